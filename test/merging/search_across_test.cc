#include "rovio_sfm/merging/search_across.h"

#include <gtest/gtest.h>

#include "merging/two_drives.h"

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

TEST(SearchAcross, LooksOnlyForLandmarksOfTheRange) {
  const TwoDrives two = MakeTwoDrives();
  const Session a = MappedSession(two, false, {}), b = MappedSession(two, true, {});
  EXPECT_TRUE(SearchAcross(a, {100, 200}, b, 7, {}, {}, StoreOf(two)).links.empty());
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
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_NE(error.find("search.max_ratio = 2"), std::string::npos) << error;
}

}  // namespace
}  // namespace rovio_sfm
