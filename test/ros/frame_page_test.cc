#include "rovio_sfm/ros/frame_page.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

FrameEventMsg Event(uint32_t index, size_t num_bytes = 0) {
  FrameEventMsg event;
  event.id.index = index;
  event.jpeg.resize(num_bytes);
  return event;
}

TEST(FramePage, IsFullAtItsNumber) {
  FramePage page(2);
  EXPECT_TRUE(page.Add(Event(3)));
  EXPECT_TRUE(page.Add(Event(4)));
  EXPECT_FALSE(page.Add(Event(7)));
  const GetFramesResponse answer = page.Take("none");
  EXPECT_EQ(answer.status.code, Status::OK);
  EXPECT_EQ(answer.frames.size(), 2u);
  EXPECT_TRUE(answer.more);
  EXPECT_EQ(answer.next_index, 7u);
}

TEST(FramePage, IsFullAtItsBytes) {
  FramePage page(kMaxPageFrames);
  EXPECT_TRUE(page.Add(Event(0, kMaxPageBytes / 2)));
  EXPECT_FALSE(page.Add(Event(1, kMaxPageBytes / 2)));
  const GetFramesResponse answer = page.Take("none");
  EXPECT_EQ(answer.frames.size(), 1u);
  EXPECT_EQ(answer.next_index, 1u);
}

TEST(FramePage, ALargeFrameAloneIsTaken) {
  FramePage page(kMaxPageFrames);
  EXPECT_TRUE(page.Add(Event(0, kMaxPageBytes + 1)));
  EXPECT_FALSE(page.Add(Event(1)));
  EXPECT_EQ(page.Take("none").frames.size(), 1u);
}

TEST(FramePage, AnEmptyOneSaysWhy) {
  FramePage page(kMaxPageFrames);
  const GetFramesResponse answer = page.Take("no such drive");
  EXPECT_EQ(answer.status.code, Status::NOT_FOUND);
  EXPECT_EQ(answer.status.message, "no such drive");
  EXPECT_FALSE(answer.more);
}

}  // namespace
}  // namespace rovio_sfm
