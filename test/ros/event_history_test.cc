#include "rovio_sfm/ros/event_history.h"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>

namespace rovio_sfm {
namespace {

FrameEventMsg::ConstPtr Event(uint32_t index, uint32_t nonce = 1, size_t num_bytes = 0) {
  auto event = boost::make_shared<FrameEventMsg>();
  event->id.drive.robot = "rovio1";
  event->id.drive.nonce = nonce;
  event->id.index = index;
  event->jpeg.resize(num_bytes);
  return event;
}

GetFramesRequest Request(uint32_t first, uint32_t max_frames) {
  GetFramesRequest request;
  request.first = Event(first)->id;
  request.max_frames = max_frames;
  return request;
}

TEST(EventHistory, PagesThroughADrive) {
  EventHistory history(100, 1000000);
  for (uint32_t i = 0; i < 5; ++i) history.Add(Event(i));
  history.Add(Event(0, 2));
  const GetFramesResponse first = history.Page(Request(1, 3));
  EXPECT_EQ(first.status.code, Status::OK);
  ASSERT_EQ(first.frames.size(), 3u);
  EXPECT_EQ(first.frames.front().id.index, 1u);
  EXPECT_TRUE(first.more);
  const GetFramesResponse second = history.Page(Request(first.next_index, 3));
  ASSERT_EQ(second.frames.size(), 1u);
  EXPECT_EQ(second.frames.front().id.index, 4u);
  EXPECT_FALSE(second.more);
}

TEST(EventHistory, ForgetsTheOldestBeyondItsNumber) {
  EventHistory history(2, 1000000);
  for (uint32_t i = 0; i < 4; ++i) history.Add(Event(i));
  const GetFramesResponse page = history.Page(Request(0, 10));
  ASSERT_EQ(page.frames.size(), 2u);
  EXPECT_EQ(page.frames.front().id.index, 2u);
}

TEST(EventHistory, ForgetsTheOldestBeyondItsBytes) {
  EventHistory history(100, 5000);
  for (uint32_t i = 0; i < 4; ++i) history.Add(Event(i, 1, 2000));
  EXPECT_EQ(history.Page(Request(0, 10)).frames.size(), 2u);
}

TEST(EventHistory, APageIsBoundedInBytes) {
  EventHistory history(100, size_t{1} << 30);
  for (uint32_t i = 0; i < 3; ++i) history.Add(Event(i, 1, size_t{9} << 20));
  const GetFramesResponse page = history.Page(Request(0, 10));
  ASSERT_EQ(page.frames.size(), 1u);
  EXPECT_TRUE(page.more);
  EXPECT_EQ(page.next_index, 1u);
}

TEST(EventHistory, GivesItsEventsByFrame) {
  EventHistory history(100, 1000000);
  history.Add(Event(0));
  history.Add(Event(1, 1, 30));
  const auto events = history.Events();
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events.begin()->first.index, 0u);
  EXPECT_EQ(events.rbegin()->second->jpeg.size(), 30u);
}

TEST(EventHistory, UnknownDriveIsNotFound) {
  EventHistory history(100, 1000000);
  EXPECT_EQ(history.Page(Request(0, 10)).status.code, Status::NOT_FOUND);
}

TEST(EventHistory, MalformedRequestIsRefused) {
  EventHistory history(100, 1000000);
  history.Add(Event(0));
  GetFramesRequest request = Request(0, 0);
  EXPECT_EQ(history.Page(request).status.code, Status::INVALID_ARGUMENT);
  request = Request(0, 101);
  EXPECT_EQ(history.Page(request).status.code, Status::INVALID_ARGUMENT);
  request = Request(0, 10);
  request.first.drive.robot = "; rm";
  EXPECT_EQ(history.Page(request).status.code, Status::INVALID_ARGUMENT);
}

TEST(EventHistory, ClearForgetsAll) {
  EventHistory history(100, 1000000);
  history.Add(Event(0));
  history.Clear();
  EXPECT_EQ(history.Page(Request(0, 10)).status.code, Status::NOT_FOUND);
}

}  // namespace
}  // namespace rovio_sfm
