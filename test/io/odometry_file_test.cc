#include "rovio_sfm/io/odometry_file.h"

#include <cmath>

#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kSecond = 1'000'000'000;

TEST(ReadOdometry, ReadsPoseAndCovariance) {
  const TemporaryFolder folder;
  const auto path = folder.Write("odometry.txt", "0.5 1 2 3 1 0 0 0 2 0 0 0 3\n");
  const auto odometry = ReadOdometry(path);
  ASSERT_EQ(odometry.size(), 1u);
  EXPECT_EQ(odometry[0].stamp_ns, kSecond / 2);
  EXPECT_EQ(odometry[0].sample.yaw_rad, 3.0);
  ASSERT_TRUE(odometry[0].sample.covariance);
  EXPECT_EQ((*odometry[0].sample.covariance)[4], 2.0);
}

TEST(ReadOdometry, KnowsNoCovarianceOfARowWithout) {
  const TemporaryFolder folder;
  const auto odometry = ReadOdometry(folder.Write("odometry.txt", "0.5 1 2 3\n"));
  ASSERT_EQ(odometry.size(), 1u);
  EXPECT_EQ(odometry[0].sample.x_m, 1.0);
  EXPECT_FALSE(odometry[0].sample.covariance);
}

TEST(ReadOdometry, RefusesBadRows) {
  const TemporaryFolder folder;
  for (const char* text : {"0 1 2\n", "0 1 2 3 1\n", "0 1 2 3 -1 0 0 0 1 0 0 0 1\n",
                           "1 0 0 0 1 0 0 0 1 0 0 0 1\n0 0 0 0 1 0 0 0 1 0 0 0 1\n"}) {
    const auto path = folder.Write("odometry.txt", text);
    EXPECT_NE(MessageOf([&] { ReadOdometry(path); }).find("odometry.txt:"), std::string::npos);
  }
}

TEST(InterpolateOdometry, TurnsTheShorterWayRound) {
  StampedOdometry a, b;
  a.sample.yaw_rad = 3.0;
  b.stamp_ns = kSecond;
  b.sample.yaw_rad = -3.0;
  b.sample.x_m = 2.0;
  const auto middle = InterpolateOdometry({a, b}, kSecond / 2, kSecond);
  ASSERT_TRUE(middle.has_value());
  EXPECT_NEAR(std::remainder(middle->yaw_rad - M_PI, 2.0 * M_PI), 0.0, 1e-12);
  EXPECT_NEAR(middle->x_m, 1.0, 1e-12);
}

TEST(InterpolateOdometry, MixesCovariancesThatAreBothKnown) {
  StampedOdometry a, b;
  b.stamp_ns = kSecond;
  a.sample.covariance = OdometryCovariance{};
  EXPECT_FALSE(InterpolateOdometry({a, b}, kSecond / 2, kSecond)->covariance);
  b.sample.covariance = OdometryCovariance{4.0};
  const auto middle = InterpolateOdometry({a, b}, kSecond / 2, kSecond);
  ASSERT_TRUE(middle && middle->covariance);
  EXPECT_EQ((*middle->covariance)[0], 2.0);
}

TEST(InterpolateOdometry, AnswersNothingOutsideAndInGaps) {
  StampedOdometry a, b;
  b.stamp_ns = kSecond;
  EXPECT_FALSE(InterpolateOdometry({a, b}, kSecond / 2, 1).has_value());
  EXPECT_FALSE(InterpolateOdometry({a, b}, 2 * kSecond, 9 * kSecond).has_value());
  EXPECT_FALSE(InterpolateOdometry({a, b}, -1, 9 * kSecond).has_value());
  EXPECT_TRUE(InterpolateOdometry({a, b}, kSecond, 1).has_value());
}

}  // namespace
}  // namespace rovio_sfm
