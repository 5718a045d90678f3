#include "rovio_sfm/merging/search_across.h"

#include <gtest/gtest.h>

#include "merging/two_drives.h"
#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

size_t NumFalse(const TwoDrives& two, const std::vector<FeatureLink>& links) {
  size_t count = 0;
  for (const FeatureLink& link : links) {
    const auto& a = two.world.views[CameraOf(false, link.a.frame)][link.a.feature];
    const auto& b = two.world.views[CameraOf(true, link.b.frame)][link.b.feature];
    count += a.point == b.point ? 0 : 1;
  }
  return count;
}

TEST(SearchAcross, FindsTheLandmarksOfAnotherSession) {
  for (const double noise_px : {0.0, 0.7}) {
    const TwoDrives two = MakeTwoDrives(TwoDrivesOptions(noise_px));
    const Session a = MappedSession(two, false, {}), b = MappedSession(two, true, OtherGauge());
    const AcrossReport report = SearchAcross(a, {}, b, 7, OtherGauge(), {}, StoreOf(two));
    EXPECT_GT(report.links.size(), 30u);
    EXPECT_EQ(NumFalse(two, report.links), 0u);
    EXPECT_GT(report.num_expected, 30u);
    EXPECT_GT(report.num_found, 0.9 * report.num_expected);
  }
}

TEST(SearchAcross, MissesWhatShouldBeThereUnderAWrongSimilarity) {
  const TwoDrives two = MakeTwoDrives();
  const Session a = MappedSession(two, false, {}), b = MappedSession(two, true, {});
  const Sim3 wrong{1.0, Eigen::Quaterniond(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY())),
                   Eigen::Vector3d::Zero()};
  const AcrossReport report = SearchAcross(a, {}, b, 7, wrong, {}, StoreOf(two));
  EXPECT_GT(report.num_expected, 10u);
  EXPECT_LT(report.num_found, 0.1 * report.num_expected);
}

// Landmarks expected in a frame that was driven forward (map units) from where it is.
uint32_t NumExpected(double forward, double max_distance_ratio) {
  const TwoDrives two = MakeTwoDrives();
  const Session a = MappedSession(two, false, {});
  Session b = MappedSession(two, true, {});
  Rigid3 pose = b.keyframe(7).cam_from_session;
  pose.translation.z() -= forward;
  b.SetPose(7, pose);
  SearchAcrossOptions options;
  options.max_view_angle_rad = 1.5;
  options.max_distance_ratio = max_distance_ratio;
  return SearchAcross(a, {}, b, 7, {}, options, StoreOf(two)).num_expected;
}

TEST(SearchAcross, ExpectsNoLandmarkFromMuchNearerOrFartherThanItsViews) {
  for (const double forward : {2.0, -4.0}) {
    const uint32_t num_visible = NumExpected(forward, 10.0);
    EXPECT_GT(num_visible, 30u) << forward;
    EXPECT_LT(NumExpected(forward, 1.2), 0.2 * num_visible) << forward;
  }
}

TEST(SearchAcross, LooksOnlyForLandmarksOfTheRange) {
  const TwoDrives two = MakeTwoDrives();
  const Session a = MappedSession(two, false, {}), b = MappedSession(two, true, {});
  EXPECT_TRUE(SearchAcross(a, {100, 200}, b, 7, {}, {}, StoreOf(two)).links.empty());
}

TEST(SearchAcross, ExpectsNoLandmarkOfFewViews) {
  const TwoDrives two = MakeTwoDrives();
  const Session a = MappedSession(two, false, {}), b = MappedSession(two, true, {});
  SearchAcrossOptions options;
  options.min_views = 100;
  const AcrossReport report = SearchAcross(a, {}, b, 7, {}, options, StoreOf(two));
  EXPECT_GT(report.links.size(), 30u);
  EXPECT_EQ(report.num_expected, 0u);
  EXPECT_EQ(report.num_found, 0u);
}

TEST(SearchAcross, CountsWhatAFrameOfTheSameSessionObservesAsFound) {
  const TwoDrives two = MakeTwoDrives();
  const Session a = MappedSession(two, false, {});
  SearchAcrossOptions options;
  uint32_t num_observed = 0;
  for (const auto& [id, landmark] : a.landmarks()) {
    if (landmark.observations.size() < static_cast<size_t>(options.min_views)) continue;
    for (const Observation& view : landmark.observations) num_observed += view.frame == 7 ? 1 : 0;
  }
  const AcrossReport report = SearchAcross(a, {}, a, 7, {}, options, StoreOf(two));
  ASSERT_GT(num_observed, 30u);
  EXPECT_GE(report.num_expected, num_observed);
  EXPECT_GE(report.num_found, num_observed);
  for (const FeatureLink& link : report.links) {
    const Landmark* landmark = ObservedLandmark(a, link.a);
    ASSERT_NE(landmark, nullptr);
    for (const Observation& view : landmark->observations) EXPECT_NE(view.frame, 7u);
  }
}

TEST(SearchAcross, FindsNothingWithoutDescriptors) {
  const TwoDrives two = MakeTwoDrives();
  const Session a = MappedSession(two, false, {}), b = MappedSession(two, true, {});
  const AcrossReport report = SearchAcross(a, {}, b, 7, {}, {}, MemoryFrameStore());
  EXPECT_TRUE(report.links.empty());
  EXPECT_EQ(report.num_expected, 0u);
}

TEST(SearchAcrossOptions, NamesTheBound) {
  SearchAcrossOptions options;
  options.max_ratio = 2.0f;
  std::string error;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_NE(error.find("max_ratio = 2"), std::string::npos) << error;
}

}  // namespace
}  // namespace rovio_sfm
