#include "rovio_sfm/ros/fetch_frames.h"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>
#include <stdexcept>
#include <vector>

#include "rovio_sfm/ros/event_history.h"
#include "rovio_sfm/ros/frame_event_message.h"

namespace rovio_sfm {
namespace {

const DriveId kDrive{"rovio1", 1'000'000'000, 42};

FrameEventMsg::ConstPtr Message(uint32_t index) {
  FrameEvent event;
  event.id = {kDrive, index};
  event.kind = FrameKind::kLight;
  event.stamp_ns = kDrive.start_ns + index;
  event.image_name = std::to_string(index);
  event.camera = {500, 500, 320, 240, 0, 0, 0, 0, 0, 640, 480};
  event.features = std::make_shared<FrameFeatures>();
  return boost::make_shared<FrameEventMsg>(ToMessage(event));
}

// A node that holds some frames.
class FetchFramesTest : public testing::Test {
 protected:
  FetchFramesTest() : history_(1000, 1u << 30) {}

  CallGetFrames Call() {
    return [this](GetFramesRequest& request, GetFramesResponse& response) {
      ++num_calls_;
      response = history_.Page(request);
      return true;
    };
  }
  HandleFrame Handle() {
    return [this](const FrameEventMsg&, const FrameEvent& event) {
      handled_.push_back(event.id.index);
    };
  }

  EventHistory history_;
  int num_calls_ = 0;
  std::vector<uint32_t> handled_;
};

TEST_F(FetchFramesTest, GetsThoseBeforeTheEndPageByPage) {
  for (uint32_t i = 0; i < 60; ++i) history_.Add(Message(i));
  EXPECT_EQ(FetchFrames(Call(), {kDrive, 3}, 50, Handle()), 50u);
  ASSERT_EQ(handled_.size(), 47u);
  EXPECT_EQ(handled_.front(), 3u);
  EXPECT_EQ(handled_.back(), 49u);
  EXPECT_GT(num_calls_, 1);
}

TEST_F(FetchFramesTest, PassesOverFramesThatAreNotHeld) {
  for (const uint32_t i : {2u, 5u, 9u}) history_.Add(Message(i));
  EXPECT_EQ(FetchFrames(Call(), {kDrive, 0}, 9, Handle()), 6u);
  EXPECT_EQ(handled_, (std::vector<uint32_t>{2, 5}));
}

TEST_F(FetchFramesTest, GetsNothingOfAnUnknownDrive) {
  history_.Add(Message(1));
  EXPECT_EQ(FetchFrames(Call(), {{"rovio2", 1, 1}, 4}, 9, Handle()), 4u);
  EXPECT_TRUE(handled_.empty());
}

TEST_F(FetchFramesTest, EndsWhereTheOtherSideDoesNotAnswer) {
  const CallGetFrames dead = [](GetFramesRequest&, GetFramesResponse&) { return false; };
  EXPECT_EQ(FetchFrames(dead, {kDrive, 4}, 9, Handle()), 4u);
}

TEST_F(FetchFramesTest, MalformedFramesAreLeftOut) {
  history_.Add(Message(1));
  auto broken = boost::make_shared<FrameEventMsg>(*Message(2));
  broken->kind = 7;
  history_.Add(broken);
  history_.Add(Message(3));
  EXPECT_EQ(FetchFrames(Call(), {kDrive, 0}, 9, Handle()), 4u);
  EXPECT_EQ(handled_, (std::vector<uint32_t>{1, 3}));
}

TEST_F(FetchFramesTest, AnswersThatGoBackwardsEndIt) {
  const CallGetFrames odd = [this](GetFramesRequest&, GetFramesResponse& response) {
    ++num_calls_;
    response.frames = {*Message(5)};
    response.more = true;
    response.next_index = 2;
    return true;
  };
  EXPECT_EQ(FetchFrames(odd, {kDrive, 4}, 9, Handle()), 6u);
  EXPECT_EQ(num_calls_, 1);
}

TEST_F(FetchFramesTest, FollowerIsAskedAgainUntilItHasTakenTheFrameAfterTheGap) {
  for (uint32_t i = 0; i < 5; ++i) history_.Add(Message(i));
  uint32_t taken = 5;
  const auto pause = [&] {
    history_.Add(Message(taken++));
    return true;
  };
  EXPECT_EQ(FetchFramesOfFollower(Call(), {kDrive, 3}, 8, Handle(), pause), 8u);
  EXPECT_EQ(handled_, (std::vector<uint32_t>{3, 4, 5, 6, 7}));
}

TEST_F(FetchFramesTest, FollowerThatIsPastTheGapIsAskedOnce) {
  for (const uint32_t i : {3u, 5u, 8u}) history_.Add(Message(i));
  const auto pause = []() -> bool { throw std::logic_error("nothing more will come"); };
  EXPECT_EQ(FetchFramesOfFollower(Call(), {kDrive, 3}, 8, Handle(), pause), 6u);
  EXPECT_EQ(handled_, (std::vector<uint32_t>{3, 5}));
}

TEST_F(FetchFramesTest, FollowerIsWaitedForNoLongerThanTheCallerWill) {
  history_.Add(Message(3));
  int num_pauses = 0;
  const auto pause = [&] { return ++num_pauses < 4; };
  EXPECT_EQ(FetchFramesOfFollower(Call(), {kDrive, 3}, 8, Handle(), pause), 4u);
  EXPECT_EQ(num_pauses, 4);
  const CallGetFrames dead = [](GetFramesRequest&, GetFramesResponse&) { return false; };
  EXPECT_EQ(FetchFramesOfFollower(dead, {kDrive, 3}, 8, Handle(), pause), 3u);
  EXPECT_EQ(num_pauses, 4);
}

}  // namespace
}  // namespace rovio_sfm
