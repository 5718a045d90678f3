#include "rovio_sfm/merging/map_bundle.h"

#include <gtest/gtest.h>

#include "merging/two_drives.h"

namespace rovio_sfm {
namespace {

TEST(MapBundle, WritesBackWhatItReadWhereNothingIsSolved) {
  const TwoDrives two = MakeTwoDrives();
  Session a = MappedSession(two, false, {}), b = MappedSession(two, true, OtherGauge());
  const Rigid3 pose = b.keyframe(5).cam_from_session;
  MapBundle bundle({{&a, {}}, {&b, Inverse(OtherGauge())}},
                   LinksOf(TrueOverlap(two, 5, 5), a.id(), b.id()), 4.0);
  bundle.Apply();
  EXPECT_LT(PoseDistance(b.keyframe(5).cam_from_session, pose), 1e-9);
  EXPECT_EQ(CheckInvariants(b), "");
}

TEST(MapBundle, MakesLinkedLandmarksOnePoint) {
  const TwoDrives two = MakeTwoDrives();
  Session a = MappedSession(two, false, {}), b = MappedSession(two, true, {});
  const FeatureLink link = LinksOf(TrueOverlap(two, 5, 5), a.id(), b.id()).front();
  const Landmark* landmark_b = ObservedLandmark(b, link.b);
  ASSERT_NE(landmark_b, nullptr);
  const TrackId track_b = b.keyframe(5).tracks[link.b.feature];
  const Eigen::Vector3d before = landmark_b->position;
  b.SetPosition(track_b, before + Eigen::Vector3d(0.002, 0.0, 0.0));
  const MapBundle bundle({{&a, {}}, {&b, {}}}, {link}, 4.0);
  bundle.Apply();
  const SharedLandmarks shared = bundle.FindShared();
  ASSERT_EQ(shared.size(), 2u);
  const auto in_a = shared.find({a.id(), a.keyframe(5).tracks[link.a.feature]});
  const auto in_b = shared.find({b.id(), track_b});
  ASSERT_TRUE(in_a != shared.end() && in_b != shared.end());
  EXPECT_EQ(in_a->second, in_b->second);
  const Eigen::Vector3d united = ObservedLandmark(b, link.b)->position;
  EXPECT_LT((united - ObservedLandmark(a, link.a)->position).norm(), 1e-12);
  EXPECT_LT((united - before).norm(), 0.002);
}

TEST(MapBundle, WeighsLinkedLandmarksByTheirViews) {
  const TwoDrives two = MakeTwoDrives();
  Session a = MappedSession(two, false, {}), b = MappedSession(two, true, {});
  for (const FeatureLink& link : LinksOf(TrueOverlap(two, 5, 5), a.id(), b.id())) {
    const Landmark *in_a = ObservedLandmark(a, link.a), *in_b = ObservedLandmark(b, link.b);
    if (in_a == nullptr || in_b == nullptr) continue;
    const auto views_a = static_cast<double>(in_a->observations.size());
    const auto views_b = static_cast<double>(in_b->observations.size());
    if (views_a == views_b) continue;
    const Eigen::Vector3d truth = in_a->position, shift(0.004, 0.0, 0.0);
    b.SetPosition(b.keyframe(5).tracks[link.b.feature], truth + shift);
    MapBundle({{&a, {}}, {&b, {}}}, {link}, 4.0).Apply();
    const Eigen::Vector3d mean = truth + views_b / (views_a + views_b) * shift;
    EXPECT_LT((ObservedLandmark(a, link.a)->position - mean).norm(), 1e-9);
    return;
  }
  FAIL() << "no link of landmarks with different numbers of views";
}

TEST(MapBundle, GivesAPointOneFeatureOfAFrame) {
  const TwoDrives two = MakeTwoDrives();
  Session a = MappedSession(two, false, {}), b = MappedSession(two, true, {});
  const auto links = LinksOf(TrueOverlap(two, 5, 5), a.id(), b.id());
  const FeatureLink *first = nullptr, *second = nullptr;  // both ends of both have landmarks
  for (const FeatureLink& link : links) {
    if (ObservedLandmark(a, link.a) == nullptr || ObservedLandmark(b, link.b) == nullptr) continue;
    (first == nullptr ? first : second) = &link;
    if (second != nullptr) break;
  }
  ASSERT_NE(second, nullptr);
  // Another landmark of b where the first one is; both are linked to one landmark of a.
  b.SetPosition(b.keyframe(5).tracks[second->b.feature], ObservedLandmark(b, first->b)->position);
  const MapBundle bundle({{&a, {}}, {&b, {}}}, {*first, {first->a, second->b}}, 1e6);
  const SharedLandmarks shared = bundle.FindShared();
  EXPECT_EQ(shared.count({b.id(), b.keyframe(5).tracks[first->b.feature]}), 1u);
  EXPECT_EQ(shared.count({b.id(), b.keyframe(5).tracks[second->b.feature]}), 0u);
}

TEST(MapBundle, DoesNotUniteLandmarksThatLieApart) {
  const TwoDrives two = MakeTwoDrives();
  Session a = MappedSession(two, false, {}), b = MappedSession(two, true, {});
  const FeatureLink link = LinksOf(TrueOverlap(two, 5, 5), a.id(), b.id()).front();
  const TrackId track_b = b.keyframe(5).tracks[link.b.feature];
  const Eigen::Vector3d far = b.landmarks().at(track_b).position + Eigen::Vector3d(0.5, 0.5, 0.0);
  b.SetPosition(track_b, far);
  const MapBundle bundle({{&a, {}}, {&b, {}}}, {link}, 4.0);
  bundle.Apply();
  EXPECT_TRUE(bundle.FindShared().empty());
  EXPECT_LT((b.landmarks().at(track_b).position - far).norm(), 1e-12);
}

TEST(LinkErrorSigmas, IsInfiniteBehindTheCamera) {
  const TwoDrives two = MakeTwoDrives();
  Session a = MappedSession(two, false, {});
  const Eigen::Vector3d behind =
      Inverse(a.keyframe(0).cam_from_session) * Eigen::Vector3d(0, 0, -1);
  EXPECT_TRUE(
      std::isinf(LinkErrorSigmas(behind, a.keyframe(0).cam_from_session, a.keyframe(0), 0)));
}

}  // namespace
}  // namespace rovio_sfm
