#include "rovio_sfm/io/export_kitti.h"

#include <gtest/gtest.h>

#include <sstream>

namespace rovio_sfm {
namespace {

// The map's x points forward, z up; the camera looks forward along its z.
const Rigid3 kLookingForward{Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5), {7.0, 8.0, 9.0}};

std::vector<double> NumbersOf(const std::string& text) {
  std::istringstream in(text);
  std::vector<double> numbers;
  for (double number = 0.0; in >> number;) numbers.push_back(number);
  return numbers;
}

TEST(KittiPosesText, BeginsWithTheIdentity) {
  const std::vector<double> expected = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  const auto numbers = NumbersOf(KittiPosesText({{5, kLookingForward}}, kLookingForward));
  ASSERT_EQ(numbers.size(), 12u);
  for (size_t i = 0; i < 12; ++i) EXPECT_NEAR(numbers[i], expected[i], 1e-12) << i;
}

TEST(KittiPosesText, MovesForwardAlongZAndTurnsRightAboutY) {
  Rigid3 later = kLookingForward;
  later.translation += Eigen::Vector3d(2.0, 0.0, 0.0);            // forward in the map
  const Eigen::AngleAxisd right(-0.3, Eigen::Vector3d::UnitZ());  // about the map's up
  later.rotation = right * later.rotation;
  const auto numbers = NumbersOf(KittiPosesText({{5, later}}, kLookingForward));
  const double c = std::cos(0.3), s = std::sin(0.3);
  const std::vector<double> expected = {c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 2};
  ASSERT_EQ(numbers.size(), 12u);
  for (size_t i = 0; i < 12; ++i) EXPECT_NEAR(numbers[i], expected[i], 1e-12) << i;
}

TEST(KittiTimesText, CountsFromTheFirst) {
  EXPECT_EQ(KittiTimesText({{1'000'000'000, {}}, {2'500'000'000, {}}}, 1'000'000'000),
            "0.000000\n1.500000\n");
}

}  // namespace
}  // namespace rovio_sfm
