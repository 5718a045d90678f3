#include "rovio_sfm/recognition/place_index.h"

#include <gtest/gtest.h>

#include "recognition/place_frames.h"

namespace rovio_sfm {
namespace {

const DriveId kFirst{"first", 1, 1};
const DriveId kSecond{"second", 2, 1};

// Frames of three places, ten of each, in one drive: frame i shows the words of place i / 10.
class PlaceIndexTest : public testing::Test {
 protected:
  PlaceIndexTest() : room_(1, 2), attic_(2, 2), index_(ModelOf({&room_, &attic_}), Options()) {
    index_.EnterDrive(kFirst, room_.world().camera);
    index_.EnterDrive(kSecond, room_.world().camera);
    for (uint32_t i = 0; i < 30; ++i) index_.Add({kFirst, 2 * i}, WordsOf(i / 10), std::nullopt);
  }

  static PlaceRecognizerOptions Options() { return {}; }

  static std::vector<uint32_t> WordsOf(uint32_t place) {
    std::vector<uint32_t> words;
    for (uint32_t i = 0; i < 200; ++i) words.push_back(200 * place + i);
    return words;
  }

  static CandidateOptions Candidates(int count) {
    CandidateOptions options;
    options.min_score = -1e6;
    options.max_candidates = count;
    options.same_place_keyframes = 9;
    return options;
  }

  SyntheticRoom room_, attic_;
  PlaceIndex index_;
};

TEST_F(PlaceIndexTest, BestCandidateShowsTheWords) {
  const auto proposal = index_.AskAll(WordsOf(1), Candidates(1));
  ASSERT_EQ(proposal.candidates.size(), 1u);
  EXPECT_EQ(proposal.candidates[0].id, (FrameId{kFirst, 20}));
  EXPECT_EQ(proposal.num_allowed, 30u);
}

TEST_F(PlaceIndexTest, CandidatesAreOfDifferentPlaces) {
  const auto proposal = index_.AskAll(WordsOf(1), Candidates(3));
  ASSERT_EQ(proposal.candidates.size(), 3u);
  for (size_t i = 1; i < 3; ++i) {
    const int gap = static_cast<int>(proposal.candidates[i].id.index) -
                    static_cast<int>(proposal.candidates[0].id.index);
    EXPECT_GT(std::abs(gap), 18);
  }
}

TEST_F(PlaceIndexTest, FramesOfTwoDrivesAreDifferentPlaces) {
  index_.Add({kSecond, 0}, WordsOf(0), std::nullopt);  // its first, as kFirst's first ten
  const auto proposal = index_.AskAll(WordsOf(0), Candidates(2));
  ASSERT_EQ(proposal.candidates.size(), 2u);
  EXPECT_NE(proposal.candidates[0].id.drive, proposal.candidates[1].id.drive);
}

TEST_F(PlaceIndexTest, ManyFramesOfOnePlaceLeaveRoomForTheNext) {
  for (uint32_t i = 30; i < 39; ++i) index_.Add({kFirst, 2 * i}, WordsOf(2), std::nullopt);
  const auto proposal = index_.AskAll(WordsOf(2), Candidates(2));  // shown by 19 frames in a row
  EXPECT_EQ(proposal.candidates.size(), 2u);
}

TEST_F(PlaceIndexTest, NothingIsProposedBelowTheScore) {
  CandidateOptions options = Candidates(3);
  options.min_score = 1e6;
  EXPECT_TRUE(index_.AskAll(WordsOf(1), options).candidates.empty());
}

TEST_F(PlaceIndexTest, OnlyTheAllowedKeyframesOfTheOwnDriveAnswer) {
  const auto proposal = index_.Ask(kFirst, 5, WordsOf(1), Candidates(3));
  EXPECT_EQ(proposal.num_allowed, 5u);
  for (const PlaceCandidate& candidate : proposal.candidates) EXPECT_LT(candidate.id.index, 10u);
  EXPECT_EQ(index_.Ask(kFirst, 0, WordsOf(1), Candidates(3)).num_allowed, 0u);
  EXPECT_EQ(index_.Ask(kSecond, 0, WordsOf(1), Candidates(3)).num_allowed, 30u);
}

TEST_F(PlaceIndexTest, AskAmongKeepsToTheFramesGiven) {
  const auto proposal =
      index_.AskAmong({{kFirst, 0}, {kFirst, 1}, {kSecond, 7}}, WordsOf(1), Candidates(3));
  EXPECT_EQ(proposal.num_allowed, 1u);  // the others are not known
  ASSERT_EQ(proposal.candidates.size(), 1u);
  EXPECT_EQ(proposal.candidates[0].id, (FrameId{kFirst, 0}));
}

TEST_F(PlaceIndexTest, MotionPriorOfADriveKeepsToTheNeighborsOfItsLastPlace) {
  const auto last = index_.AskAll(WordsOf(2), Candidates(1));
  index_.Add({kSecond, 0}, WordsOf(2), last.result);
  const auto blank = index_.Ask(kSecond, 0, {}, Candidates(1));
  ASSERT_EQ(blank.candidates.size(), 1u);
  EXPECT_GE(blank.candidates[0].id.index, 38u);
}

TEST_F(PlaceIndexTest, NeighborsEndWithTheDrive) {
  EXPECT_EQ(index_.Neighbors({kFirst, 2}, -1, 5), (std::vector<FrameId>{{kFirst, 0}}));
  EXPECT_EQ(index_.Neighbors({kFirst, 2}, 1, 2), (std::vector<FrameId>{{kFirst, 4}, {kFirst, 6}}));
  EXPECT_TRUE(index_.Neighbors({kFirst, 3}, 1, 2).empty());
}

TEST_F(PlaceIndexTest, FramesBetweenAreThoseKnown) {
  EXPECT_EQ(index_.FramesBetween(kFirst, 3, 6), (std::vector<FrameId>{{kFirst, 4}, {kFirst, 6}}));
  EXPECT_TRUE(index_.FramesBetween({"third", 3, 1}, 0, 9).empty());
}

TEST_F(PlaceIndexTest, CameraIsKnownOfKnownFramesOnly) {
  EXPECT_NE(index_.FindCamera({kFirst, 4}), nullptr);
  EXPECT_EQ(index_.FindCamera({kFirst, 5}), nullptr);
  EXPECT_EQ(index_.FindCamera({{"third", 3, 1}, 4}), nullptr);
}

}  // namespace
}  // namespace rovio_sfm
