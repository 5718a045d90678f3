#include "rovio_sfm/app/gap_filler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "rovio_sfm/util/log.h"

namespace rovio_sfm {
namespace {

// A mapper, senders and a clock that do nothing by themselves.
class GapFillerTest : public testing::Test {
 protected:
  GapFillerTest()
      : filler_(
            {5.0, 4}, [this](const FrameId& id) { return std::min(next_[id.drive], id.index); },
            [this](const GapFetch& fetch) { fetches_.push_back(fetch); }) {
    SetLogSink([this](LogLevel level, const std::string& message) {
      if (level == LogLevel::kWarning) warnings_.push_back(message);
    });
  }
  ~GapFillerTest() override {
    SetLogSink([](LogLevel, const std::string&) {});
  }

  ArrivedFrame Frame(uint32_t index, const std::string& robot = "rovio1") {
    const FrameId id = {{robot, 1, 1}, index};
    return {id, [this, id] {
              delivered_ +=
                  (id.drive.robot == "rovio1" ? "" : "b") + std::to_string(id.index) + " ";
              next_[id.drive] = id.index + 1;
            }};
  }
  void Add(uint32_t index, const std::string& robot = "rovio1") {
    filler_.Add(Frame(index, robot), now_s_);
  }
  void Answer(uint64_t ticket, const std::vector<uint32_t>& indices) {
    std::vector<ArrivedFrame> found;
    for (const uint32_t index : indices) found.push_back(Frame(index));
    filler_.TakeAnswer(ticket, found, now_s_);
  }

  double now_s_ = 100.0;
  std::map<DriveId, uint32_t> next_;
  std::vector<GapFetch> fetches_;
  std::vector<std::string> warnings_;
  std::string delivered_;
  GapFiller filler_;
};

TEST_F(GapFillerTest, FramesWithoutAGapFlowThrough) {
  for (uint32_t i = 0; i < 3; ++i) Add(i);
  EXPECT_EQ(delivered_, "0 1 2 ");
  EXPECT_TRUE(fetches_.empty());
}

TEST_F(GapFillerTest, HoldsFramesInOrderUntilTheGapIsFilled) {
  Add(0);
  Add(3);
  Add(4);
  EXPECT_EQ(delivered_, "0 ");
  EXPECT_EQ(filler_.NumHeld(), 2u);
  ASSERT_EQ(fetches_.size(), 1u);
  EXPECT_EQ(fetches_[0].first.index, 1u);
  EXPECT_EQ(fetches_[0].end, 3u);
  Answer(fetches_[0].ticket, {1, 2});
  EXPECT_EQ(delivered_, "0 1 2 3 4 ");
  EXPECT_EQ(filler_.NumHeld(), 0u);
  EXPECT_EQ(filler_.num_given_up(), 0u);
}

TEST_F(GapFillerTest, OtherRobotsFlowMeanwhile) {
  Add(2);
  Add(0, "rovio2");
  Add(1, "rovio2");
  EXPECT_EQ(delivered_, "b0 b1 ");
}

TEST_F(GapFillerTest, WhatTheSenderNoLongerHasStaysMissing) {
  Add(4);
  Answer(fetches_.at(0).ticket, {2});
  EXPECT_EQ(delivered_, "2 4 ");
  EXPECT_EQ(fetches_.size(), 1u);
}

TEST_F(GapFillerTest, GapAmongHeldFramesIsFetchedNext) {
  Add(1);
  Add(2);
  Add(5);
  Add(6);
  Answer(fetches_.at(0).ticket, {0});
  EXPECT_EQ(delivered_, "0 1 2 ");
  ASSERT_EQ(fetches_.size(), 2u);
  EXPECT_EQ(fetches_[1].first.index, 3u);
  Answer(fetches_[1].ticket, {3, 4});
  EXPECT_EQ(delivered_, "0 1 2 3 4 5 6 ");
}

TEST_F(GapFillerTest, FetchThatIsNotAnsweredInTimeIsGivenUpAndMappingGoesOn) {
  Add(2);
  Add(3);
  now_s_ += 4.9;
  filler_.CheckTime(now_s_);
  EXPECT_EQ(delivered_, "");
  now_s_ += 0.2;
  filler_.CheckTime(now_s_);
  EXPECT_EQ(delivered_, "2 3 ");
  EXPECT_EQ(filler_.num_given_up(), 1u);
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_NE(warnings_[0].find("frames 0 to 1 of rovio1"), std::string::npos) << warnings_[0];
}

TEST_F(GapFillerTest, LateAnswerIsIgnored) {
  Add(2);
  filler_.CheckTime(now_s_ + 6.0);
  Answer(fetches_.at(0).ticket, {0, 1});
  EXPECT_EQ(delivered_, "2 ");
  EXPECT_EQ(filler_.num_late_answers(), 1u);
}

TEST_F(GapFillerTest, SenderThatHangsCostsTheTimeOnceAndIsAskedAgainWhenItAnswers) {
  Add(2);
  filler_.CheckTime(now_s_ + 6.0);
  Add(5);
  Add(9);
  EXPECT_EQ(delivered_, "2 5 9 ");
  EXPECT_EQ(fetches_.size(), 1u);
  EXPECT_EQ(filler_.num_given_up(), 3u);
  EXPECT_EQ(warnings_.size(), 1u);
  Answer(fetches_[0].ticket, {0, 1});
  Add(11);
  ASSERT_EQ(fetches_.size(), 2u);
  Answer(fetches_[1].ticket, {10});
  EXPECT_EQ(delivered_, "2 5 9 10 11 ");
}

TEST_F(GapFillerTest, FullHoldGivesTheFetchUp) {
  Add(2);
  for (uint32_t i = 3; i < 6; ++i) Add(i);
  EXPECT_EQ(delivered_, "");
  Add(6);
  EXPECT_EQ(delivered_, "2 3 4 5 6 ");
  EXPECT_EQ(filler_.num_given_up(), 1u);
}

TEST_F(GapFillerTest, HoldFullOfBytesGivesTheFetchUp) {
  constexpr size_t kMany = 100u << 20;
  ArrivedFrame first = Frame(2), second = Frame(3);
  first.num_bytes = second.num_bytes = kMany;
  filler_.Add(std::move(first), now_s_);
  EXPECT_EQ(filler_.NumHeld(), 1u);
  filler_.Add(std::move(second), now_s_);
  EXPECT_EQ(filler_.NumHeld(), 0u);
  EXPECT_EQ(delivered_, "2 3 ");
  EXPECT_EQ(filler_.num_given_up(), 1u);
}

TEST_F(GapFillerTest, EndedWaitHandsOnWhatIsHeldOfThatRobotAlone) {
  Add(2);
  Add(3);
  Add(7, "rovio2");
  filler_.EndWait("rovio1", now_s_);
  EXPECT_EQ(delivered_, "2 3 ");
  EXPECT_EQ(filler_.NumHeld(), 1u);
  filler_.EndWait("rovio3", now_s_);
  filler_.EndAllWaits(now_s_);
  EXPECT_EQ(delivered_, "2 3 b7 ");
}

TEST_F(GapFillerTest, NewDriveOfARobotWaitsForTheGapOfItsLast) {
  Add(2);
  filler_.Add({{{"rovio1", 1, 2}, 0}, [this] { delivered_ += "new "; }}, now_s_);
  EXPECT_EQ(delivered_, "");
  Answer(fetches_.at(0).ticket, {});
  EXPECT_EQ(delivered_, "2 new ");
}

TEST_F(GapFillerTest, AnswersToNobodyAreIgnored) {
  Answer(17, {1});
  EXPECT_EQ(delivered_, "");
  EXPECT_EQ(filler_.num_late_answers(), 0u);
}

}  // namespace
}  // namespace rovio_sfm
