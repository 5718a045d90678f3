#include "rovio_sfm/geometry/ransac.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <set>

namespace rovio_sfm {
namespace {

// y = slope x + offset.
struct Line {
  double slope = 0.0, offset = 0.0;
};

class LineEstimator {
 public:
  using Model = Line;
  static constexpr int kSampleSize = 2;

  explicit LineEstimator(std::vector<Eigen::Vector2d> points) : points_(std::move(points)) {}

  uint32_t NumData() const { return static_cast<uint32_t>(points_.size()); }

  std::vector<Line> Solve(const std::vector<uint32_t>& sample) const {
    const Eigen::Vector2d delta = points_[sample[1]] - points_[sample[0]];
    if (std::abs(delta.x()) < 1e-9) return {};
    const double slope = delta.y() / delta.x();
    return {{slope, points_[sample[0]].y() - slope * points_[sample[0]].x()}};
  }

  double SquaredResidual(const Line& line, uint32_t i) const {
    return std::pow(points_[i].y() - line.slope * points_[i].x() - line.offset, 2);
  }

  std::optional<Line> Refine(const Line&, const std::vector<uint32_t>& inliers) const {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const uint32_t i : inliers) {
      const Eigen::Vector2d& p = points_[i];
      n += 1, sx += p.x(), sy += p.y(), sxx += p.x() * p.x(), sxy += p.x() * p.y();
    }
    const double determinant = n * sxx - sx * sx;
    if (!(determinant > 1e-9)) return std::nullopt;
    const double slope = (n * sxy - sx * sy) / determinant;
    return Line{slope, (sy - slope * sx) / n};
  }

 private:
  std::vector<Eigen::Vector2d> points_;
};

std::vector<Eigen::Vector2d> MakePoints(int num_inliers, int num_outliers, double noise) {
  Rng rng(11);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < num_inliers; ++i) {
    const double x = rng.Uniform(-1.0, 1.0);
    points.emplace_back(x, 2.0 * x + 0.5 + noise * rng.Gaussian());
  }
  for (int i = 0; i < num_outliers; ++i) {
    points.emplace_back(rng.Uniform(-1.0, 1.0), rng.Uniform(-3.0, 3.0));
  }
  return points;
}

RansacOptions MakeOptions(double threshold) {
  RansacOptions options;
  options.threshold = threshold;
  return options;
}

TEST(Ransac, IsExactWithoutNoise) {
  Rng rng(1);
  const auto report = Ransac(LineEstimator(MakePoints(50, 50, 0.0)), MakeOptions(1e-6), rng);
  ASSERT_TRUE(report);
  EXPECT_NEAR(report->model.slope, 2.0, 1e-9);
  EXPECT_NEAR(report->model.offset, 0.5, 1e-9);
  ASSERT_GE(report->inliers.size(), 50u);
  for (uint32_t i = 0; i < 50; ++i) EXPECT_EQ(report->inliers[i], i);
}

TEST(Ransac, StaysNearWithNoiseAndTwoThirdsOutliers) {
  Rng rng(1);
  const auto report = Ransac(LineEstimator(MakePoints(60, 120, 0.01)), MakeOptions(0.03), rng);
  ASSERT_TRUE(report);
  EXPECT_NEAR(report->model.slope, 2.0, 0.03);
  EXPECT_NEAR(report->model.offset, 0.5, 0.02);
}

TEST(Ransac, SameSeedGivesSameReport) {
  const LineEstimator estimator(MakePoints(60, 120, 0.01));
  Rng rng_a(7), rng_b(7);
  const auto a = Ransac(estimator, MakeOptions(0.03), rng_a);
  const auto b = Ransac(estimator, MakeOptions(0.03), rng_b);
  EXPECT_EQ(a->model.slope, b->model.slope);
  EXPECT_EQ(a->inliers, b->inliers);
  EXPECT_EQ(a->num_iterations, b->num_iterations);
}

TEST(Ransac, StopsEarlyWithGoodDataAndNeverExceedsItsLimit) {
  Rng rng(1);
  RansacOptions options = MakeOptions(0.05);
  EXPECT_EQ(Ransac(LineEstimator(MakePoints(50, 0, 0.01)), options, rng)->num_iterations,
            options.min_iterations);
  options.max_iterations = 30;
  EXPECT_LE(Ransac(LineEstimator(MakePoints(5, 500, 0.01)), options, rng)->num_iterations, 30);
}

TEST(Ransac, RefusesTooFewAndDegenerateData) {
  Rng rng(1);
  EXPECT_FALSE(Ransac(LineEstimator({}), MakeOptions(0.1), rng));
  EXPECT_FALSE(Ransac(LineEstimator({{0, 0}}), MakeOptions(0.1), rng));
  EXPECT_FALSE(Ransac(LineEstimator({{0, 0}, {0, 0}, {0, 0}}), MakeOptions(0.1), rng));
}

TEST(NumSamplesNeeded, FollowsTheFormula) {
  EXPECT_EQ(NumSamplesNeeded(1.0, 5, 0.99), 1.0);
  EXPECT_EQ(NumSamplesNeeded(0.5, 5, 0.99), 146.0);
  EXPECT_TRUE(std::isinf(NumSamplesNeeded(0.0, 5, 0.99)));
}

TEST(HasDrawnEnough, CountsTheInliersOfThePoolOnly) {
  RansacOptions options = MakeOptions(1.0);
  options.confidence = 0.99;
  options.min_iterations = 3;
  const std::vector<uint32_t> inliers = {0, 1, 2, 3, 100};
  EXPECT_TRUE(HasDrawnEnough(3, inliers, 4, 5, options));
  EXPECT_FALSE(HasDrawnEnough(2, inliers, 4, 5, options));
  EXPECT_TRUE(HasDrawnEnough(146, inliers, 8, 5, options));
  EXPECT_FALSE(HasDrawnEnough(145, inliers, 8, 5, options));
  EXPECT_FALSE(HasDrawnEnough(100000, {}, 8, 5, options));
}

TEST(DrawSample, IsDistinctAndCoversAllData) {
  Rng rng(5);
  std::set<uint32_t> seen;
  std::vector<uint32_t> sample(4);
  for (int i = 0; i < 100; ++i) {
    DrawSample(5, rng, &sample);
    EXPECT_EQ(std::set<uint32_t>(sample.begin(), sample.end()).size(), 4u);
    seen.insert(sample.begin(), sample.end());
  }
  EXPECT_EQ(seen.size(), 5u);
}

TEST(ProsacPoolSize, GrowsFromTheBestToAll) {
  EXPECT_EQ(ProsacPoolSize(500, 5, 0, 100), 20u);
  EXPECT_EQ(ProsacPoolSize(500, 5, 50, 100), 260u);
  EXPECT_EQ(ProsacPoolSize(500, 5, 100, 100), 500u);
  EXPECT_EQ(ProsacPoolSize(500, 5, 0, 0), 500u);
  EXPECT_EQ(ProsacPoolSize(6, 5, 0, 100), 6u);
}

}  // namespace
}  // namespace rovio_sfm
