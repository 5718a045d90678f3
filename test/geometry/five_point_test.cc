#include "rovio_sfm/geometry/five_point.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "rovio_sfm/geometry/essential.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

struct Sample {
  Rigid3 b_from_a;
  std::vector<Eigen::Vector2d> points_a, points_b;
};

Eigen::Vector3d RandomVector(double size, Rng& rng) {
  return {rng.Uniform(-size, size), rng.Uniform(-size, size), rng.Uniform(-size, size)};
}

Sample MakeSample(Rng& rng, bool planar) {
  Sample sample;
  const Eigen::Vector3d turn = RandomVector(0.3, rng);
  sample.b_from_a.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized());
  sample.b_from_a.translation = RandomVector(1.0, rng).normalized();
  for (int i = 0; i < 5; ++i) {
    Eigen::Vector3d point = Eigen::Vector3d(0, 0, 5) + RandomVector(2.0, rng);
    if (planar) point.z() = 5.0 + 0.2 * point.x();
    sample.points_a.push_back(point.hnormalized());
    sample.points_b.push_back((sample.b_from_a * point).hnormalized());
  }
  return sample;
}

double DistanceToNearest(const std::vector<Eigen::Matrix3d>& essentials, const Rigid3& b_from_a) {
  const Eigen::Matrix3d truth = EssentialFromPose(b_from_a);
  double nearest = 10.0;
  for (const Eigen::Matrix3d& essential : essentials) {
    nearest = std::min({nearest, (essential - truth).norm(), (essential + truth).norm()});
  }
  return nearest;
}

TEST(SolveFivePoint, FindsTheTrueMatrixInGeneralAndPlanarScenes) {
  Rng rng(2);
  for (const bool planar : {false, true}) {
    int num_found = 0;
    for (int trial = 0; trial < 200; ++trial) {
      const Sample sample = MakeSample(rng, planar);
      const auto essentials = SolveFivePoint(sample.points_a, sample.points_b);
      num_found += DistanceToNearest(essentials, sample.b_from_a) < 1e-6 ? 1 : 0;
    }
    EXPECT_GE(num_found, 190);
  }
}

TEST(SolveFivePoint, EverySolutionIsEssentialAndFitsTheMatches) {
  Rng rng(5);
  for (int trial = 0; trial < 50; ++trial) {
    const Sample sample = MakeSample(rng, false);
    const auto essentials = SolveFivePoint(sample.points_a, sample.points_b);
    EXPECT_LE(essentials.size(), 10u);
    for (const Eigen::Matrix3d& essential : essentials) {
      for (size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(
            sample.points_b[i].homogeneous().dot(essential * sample.points_a[i].homogeneous()), 0.0,
            1e-9);
      }
      const Eigen::Vector3d values = essential.jacobiSvd().singularValues();
      EXPECT_NEAR(values(0), 1.0, 1e-3);
      EXPECT_NEAR(values(2), 0.0, 1e-3);
    }
  }
}

TEST(SolveFivePoint, SurvivesDegenerateMatches) {
  const std::vector<Eigen::Vector2d> same(5, Eigen::Vector2d(0.1, 0.2));
  for (const Eigen::Matrix3d& essential : SolveFivePoint(same, same)) {
    EXPECT_TRUE(essential.allFinite());
  }
}

}  // namespace
}  // namespace rovio_sfm
