#include "rovio_sfm/recognition/verify_place.h"

#include <gtest/gtest.h>

#include "recognition/place_frames.h"
#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

const DriveId kFirst{"first", 1, 1};
const DriveId kSecond{"second", 2, 1};

FindPlaceFrame FramesOf(const SyntheticRoom& room) {
  return [&room](const FrameId& id) -> std::optional<PlaceFrame> {
    if (id.index >= room.world().views.size()) return std::nullopt;
    return room.FrameOf(id.drive, id.index);
  };
}

TEST(VerifyPlace, AcceptsAFrameOfTheSameRoomWithItsRelativePose) {
  const SyntheticRoom room(1);
  const PlaceVerification verified =
      VerifyPlace(room.FrameOf(kFirst, 0), room.FrameOf(kSecond, 1), {}, 1);
  ASSERT_EQ(verified.refusal, PlaceRefusal::kNone);
  EXPECT_EQ(verified.pair.other, (FrameId{kFirst, 0}));
  EXPECT_GE(verified.pair.inliers.size(), 100u);
  const Rigid3 truth = room.world().cams_from_map[1] * Inverse(room.world().cams_from_map[0]);
  EXPECT_LT(verified.pair.query_from_other.rotation.angularDistance(truth.rotation), 0.01);
  EXPECT_GT(verified.pair.query_from_other.translation.dot(truth.translation.normalized()), 0.99);
}

TEST(VerifyPlace, RefusesAForeignRoomByGeometry) {
  const SyntheticRoom room(1), foreign(2);
  EXPECT_EQ(VerifyPlace(foreign.FrameOf(kFirst, 0), room.FrameOf(kSecond, 1), {}, 1).refusal,
            PlaceRefusal::kGeometry);
}

TEST(VerifyPlace, RefusesInliersInOneCornerOfTheImage) {
  const SyntheticRoom room(1);
  PlaceFrame corner = room.FrameOf(kFirst, 0);
  auto crowded = std::make_shared<FrameFeatures>(*corner.features);
  for (Keypoint& keypoint : crowded->keypoints) keypoint.x_px = keypoint.y_px = 5.0f;
  corner.features = crowded;
  EXPECT_EQ(VerifyPlace(corner, room.FrameOf(kSecond, 1), {}, 1).refusal, PlaceRefusal::kSpread);
}

TEST(VerifyPlace, RefusesInliersInOneCornerOfTheQuery) {
  const SyntheticRoom room(1);
  PlaceFrame corner = room.FrameOf(kSecond, 1);
  auto crowded = std::make_shared<FrameFeatures>(*corner.features);
  for (Keypoint& keypoint : crowded->keypoints) keypoint.x_px = keypoint.y_px = 5.0f;
  corner.features = crowded;
  EXPECT_EQ(VerifyPlace(room.FrameOf(kFirst, 0), corner, {}, 1).refusal, PlaceRefusal::kSpread);
}

TEST(VerifyPlace, MatchesTwoDifferentCameras) {
  const SyntheticRoom room(1);
  PlaceFrame other = room.FrameOf(kFirst, 0);
  other.camera.fx *= 0.5;
  other.camera.fy *= 0.5;
  EXPECT_EQ(VerifyPlace(other, room.FrameOf(kSecond, 1), {}, 1).refusal, PlaceRefusal::kNone);
}

TEST(VerifyPlace, DependsOnlyOnSeedAndIds) {
  const SyntheticRoom room(1);
  const auto once = VerifyPlace(room.FrameOf(kFirst, 0), room.FrameOf(kSecond, 1), {}, 7);
  const auto again = VerifyPlace(room.FrameOf(kFirst, 0), room.FrameOf(kSecond, 1), {}, 7);
  EXPECT_EQ(once.pair.query_from_other.rotation.coeffs(),
            again.pair.query_from_other.rotation.coeffs());
  EXPECT_EQ(once.pair.inliers.size(), again.pair.inliers.size());
}

// The same, its first hundred features larger than the others and, if they are to be strange, like
// nothing else.
PlaceFrame WithLargeOnes(PlaceFrame frame, bool strange) {
  constexpr size_t kNumLarge = 100;
  auto features = std::make_shared<FrameFeatures>(*frame.features);
  for (size_t i = 0; i < kNumLarge; ++i) features->keypoints[i].size_px = 20.0f;
  Rng rng(9);
  for (size_t i = 0; strange && i < kNumLarge * features->descriptors.length; ++i) {
    features->descriptors.data[i] = static_cast<uint8_t>(rng.UniformInt(91));
  }
  frame.features = features;
  return frame;
}

VerifyPlaceOptions ByAHundred() {
  VerifyPlaceOptions options;
  options.glance_features = 100;
  return options;
}

TEST(VerifyPlace, AGlanceThatHoldsChangesNothing) {
  const SyntheticRoom room(1);
  const PlaceFrame candidate = WithLargeOnes(room.FrameOf(kFirst, 0), false);
  const PlaceFrame query = WithLargeOnes(room.FrameOf(kSecond, 1), false);
  const PlaceVerification whole = VerifyPlace(candidate, query, {}, 1);
  const PlaceVerification glanced = VerifyPlace(candidate, query, ByAHundred(), 1);
  ASSERT_EQ(glanced.refusal, PlaceRefusal::kNone);
  EXPECT_EQ(glanced.pair.inliers.size(), whole.pair.inliers.size());
  EXPECT_EQ(glanced.pair.query_from_other.rotation.coeffs(),
            whole.pair.query_from_other.rotation.coeffs());
}

TEST(VerifyPlace, RefusesAtAGlanceWhatTheLargestFeaturesDoNotShare) {
  const SyntheticRoom room(1);
  const PlaceFrame candidate = WithLargeOnes(room.FrameOf(kFirst, 0), true);
  const PlaceFrame query = WithLargeOnes(room.FrameOf(kSecond, 1), false);
  EXPECT_EQ(VerifyPlace(candidate, query, {}, 1).refusal, PlaceRefusal::kNone);
  EXPECT_EQ(VerifyPlace(candidate, query, ByAHundred(), 1).refusal, PlaceRefusal::kGeometry);
}

TEST(MatchAround, GoesOnUntilTheMostAllowed) {
  const SyntheticRoom room(1);
  VerifyPlaceOptions options;
  options.max_neighbors = 2;
  const auto pairs = MatchAround({{kFirst, 1}, {kFirst, 2}, {kFirst, 3}}, room.FrameOf(kSecond, 1),
                                 FramesOf(room), options, 1);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[1].other.index, 2u);
}

TEST(MatchAround, StopsAtAFrameOutOfReach) {
  const SyntheticRoom room(1);
  const auto pairs =
      MatchAround({{kFirst, 99}, {kFirst, 1}}, room.FrameOf(kSecond, 1), FramesOf(room), {}, 1);
  EXPECT_TRUE(pairs.empty());
}

TEST(MatchAround, StopsAtAFrameThatShowsAnotherPlace) {
  const SyntheticRoom room(1), foreign(2);
  const FindPlaceFrame find = [&](const FrameId& id) -> std::optional<PlaceFrame> {
    return (id.index == 2 ? foreign : room).FrameOf(id.drive, id.index);
  };
  const auto pairs =
      MatchAround({{kFirst, 1}, {kFirst, 2}, {kFirst, 0}}, room.FrameOf(kSecond, 1), find, {}, 1);
  EXPECT_EQ(pairs.size(), 1u);
}

TEST(VerifyPlaceOptions, NamesWhatIsOutOfRange) {
  VerifyPlaceOptions options;
  std::string error;
  EXPECT_TRUE(IsValid(options, &error));
  options.min_cells = 17;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_NE(error.find("min_cells"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
