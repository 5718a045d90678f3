#include "rovio_sfm/app/changed_parts.h"

#include <gtest/gtest.h>

#include "app/small_picture.h"

namespace rovio_sfm {
namespace {

MergeReport Overlap(MergeVerdict verdict, uint32_t other, uint32_t query) {
  MergeReport report;
  report.verdict = verdict;
  report.other_session = {other};
  report.query_session = {query};
  return report;
}

std::shared_ptr<const std::vector<MergeReport>> Merges(std::vector<MergeReport> reports) {
  return std::make_shared<const std::vector<MergeReport>>(std::move(reports));
}

std::vector<uint32_t> Numbers(const std::vector<SessionId>& ids) {
  std::vector<uint32_t> numbers;
  for (const SessionId id : ids) numbers.push_back(id.value);
  return numbers;
}

// 0 stands for the root map's place.
std::vector<uint32_t> Numbers(const std::vector<CloudPlace>& places) {
  std::vector<uint32_t> numbers;
  for (const CloudPlace& place : places) numbers.push_back(place.is_root ? 0 : place.map.value);
  return numbers;
}

using Ids = std::vector<uint32_t>;

TEST(ChangedParts, TakesEverythingFirstThenNothing) {
  ChangedParts parts;
  const MapPicture picture = Picture(2);
  EXPECT_EQ(Numbers(parts.TakeSessions(picture).sessions), (Ids{1, 2}));
  EXPECT_EQ(Numbers(parts.TakeClouds(picture).clouds), (Ids{0, 2}));
  EXPECT_TRUE(parts.TakeGauges(picture));
  const MapPicture again = After(picture, [](MapSnapshot*) {});
  EXPECT_TRUE(parts.TakeSessions(again).sessions.empty());
  EXPECT_TRUE(parts.TakeClouds(again).clouds.empty());
  EXPECT_FALSE(parts.TakeGauges(again));
}

TEST(ChangedParts, SessionOfOneRobotLeavesThatOfAnotherAlone) {
  ChangedParts parts;
  MapPicture picture = Picture(2);
  parts.TakeSessions(picture);
  parts.TakeClouds(picture);
  parts.TakeGauges(picture);
  picture = After(picture, [](MapSnapshot* maps) { ++maps->sessions[1].revision; });
  const SessionChanges changes = parts.TakeSessions(picture);
  EXPECT_EQ(Numbers(changes.sessions), (Ids{2}));
  EXPECT_TRUE(changes.gone.empty());
  EXPECT_EQ(Numbers(parts.TakeClouds(picture).clouds), (Ids{2}));
  EXPECT_FALSE(parts.TakeGauges(picture));
}

TEST(ChangedParts, PlaceInTheMapScaleAndGaugeCount) {
  const std::vector<std::function<void(SessionSnapshot*)>> changes = {
      [](SessionSnapshot* session) { session->map = {1}; },
      [](SessionSnapshot* session) { session->map_from_session.translation.x() = 2.0; },
      [](SessionSnapshot* session) { ++session->gauge_revision; },
      [](SessionSnapshot* session) {
        session->scale = MapScale{2.0, 0.1, "odometry"};
      }};
  for (const auto& change : changes) {
    ChangedParts parts;
    MapPicture picture = Picture(2);
    parts.TakeSessions(picture);
    parts.TakeGauges(picture);
    picture = After(picture, [&](MapSnapshot* maps) { change(&maps->sessions[1]); });
    EXPECT_EQ(Numbers(parts.TakeSessions(picture).sessions), (Ids{2}));
    EXPECT_TRUE(parts.TakeGauges(picture));
  }
}

TEST(ChangedParts, CloudApartGoesWhenItsMapJoinsTheRoot) {
  ChangedParts parts;
  MapPicture picture = Picture(2);
  parts.TakeClouds(picture);
  picture = After(picture, [](MapSnapshot* maps) { maps->sessions[1].map = {1}; });
  const CloudChanges changes = parts.TakeClouds(picture);
  EXPECT_EQ(Numbers(changes.clouds), (Ids{0}));
  EXPECT_EQ(Numbers(changes.gone), (Ids{2}));
}

TEST(ChangedParts, CloudChangesWithTheLandmarksThatAreShared) {
  ChangedParts parts;
  MapPicture picture = Picture(2);
  parts.TakeClouds(picture);
  picture = After(picture, [](MapSnapshot* maps) {
    maps->shared_landmarks[MapId{1}] = std::make_shared<const SharedLandmarks>();
  });
  EXPECT_EQ(Numbers(parts.TakeClouds(picture).clouds), (Ids{0}));
}

TEST(ChangedParts, AnotherRootIsShownInTheSamePlace) {
  ChangedParts parts;
  MapPicture picture = After(Picture(2), [](MapSnapshot* maps) { maps->sessions[0].frames = {}; });
  CloudChanges changes = parts.TakeClouds(picture);
  ASSERT_EQ(Numbers(changes.clouds), (Ids{0}));
  EXPECT_EQ(changes.clouds[0].map.value, 2u);
  changes = parts.TakeClouds(Picture(2));
  ASSERT_EQ(Numbers(changes.clouds), (Ids{0, 2}));
  EXPECT_EQ(changes.clouds[0].map.value, 1u);
  EXPECT_TRUE(changes.gone.empty());
}

TEST(ChangedParts, SameNumbersAfterAResetAreOtherSessions) {
  ChangedParts parts;
  MapPicture picture = Picture(2);
  parts.TakeSessions(picture);
  parts.TakeClouds(picture);
  picture = Picture(1);
  ++picture.epoch;
  const SessionChanges changes = parts.TakeSessions(picture);
  EXPECT_EQ(Numbers(changes.sessions), (Ids{1}));
  EXPECT_EQ(Numbers(changes.gone), (Ids{2}));
  EXPECT_EQ(Numbers(parts.TakeClouds(picture).clouds), (Ids{0}));
}

TEST(ChangedParts, OverlapsChangeWithTheirReportsAndTheirTwoSessions) {
  ChangedParts parts;
  MapPicture picture = Picture(3);
  picture.merges =
      Merges({Overlap(MergeVerdict::kAccepted, 1, 2), Overlap(MergeVerdict::kRefused, 3, 2)});
  EXPECT_EQ(parts.TakeSessions(picture).overlaps, (std::set<SessionId>{{1}}));
  picture = After(picture, [](MapSnapshot* maps) { ++maps->sessions[2].revision; });
  EXPECT_TRUE(parts.TakeSessions(picture).overlaps.empty());
  picture = After(picture, [](MapSnapshot* maps) { ++maps->sessions[1].revision; });
  EXPECT_EQ(parts.TakeSessions(picture).overlaps, (std::set<SessionId>{{1}}));
  picture.merges = Merges({Overlap(MergeVerdict::kUndone, 1, 2)});
  EXPECT_EQ(parts.TakeSessions(picture).overlaps, (std::set<SessionId>{{1}}));
  EXPECT_TRUE(parts.TakeSessions(picture).overlaps.empty());
}

}  // namespace
}  // namespace rovio_sfm
