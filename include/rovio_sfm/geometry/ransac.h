#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {

struct RansacOptions {
  int max_iterations = 1000;  // samples, 1 … 1 000 000
  int min_iterations = 30;    // samples, 0 … max_iterations; guards against one lucky poor model
  double confidence = 0.999;  // that one sample was free of outliers, in (0, 1)
  double threshold = 0.0;     // largest residual of an inlier, in the estimator's unit; > 0
  // PROSAC (Chum 2005): the data are sorted, best first, and early samples come from the best ones.
  // After this many samples all data take part; 0 draws from all at once.
  int prosac_samples = 0;
};

template <typename Model>
struct RansacReport {
  Model model{};                  // the best one found
  double score = 0.0;             // truncated loss (MSAC): sum of min(residual^2 / threshold^2, 1)
  std::vector<uint32_t> inliers;  // indices of data within the threshold, ascending
  int num_iterations = 0;
};

// How many samples find one without outliers with this confidence, at this share of inliers.
double NumSamplesNeeded(double inlier_share, int sample_size, double confidence);

// Distinct indices below count, drawn without order; needs sample->size() <= count.
void DrawSample(uint32_t count, Rng& rng, std::vector<uint32_t>* sample);

// The size of the set of best data from which sample number iteration is drawn.
uint32_t ProsacPoolSize(uint32_t num_data, int sample_size, int iteration, int prosac_samples);

// True if so many samples were drawn that, at the share of inliers among the best pool_size data,
// one sample was free of outliers with the confidence asked for; all samples came from those data.
bool HasDrawnEnough(int num_samples, const std::vector<uint32_t>& inliers, uint32_t pool_size,
                    int sample_size, const RansacOptions& options);

namespace ransac_internal {

template <typename Estimator, typename = void>
struct HasTruncatedLoss : std::false_type {};
template <typename Estimator>
struct HasTruncatedLoss<Estimator, std::void_t<decltype(&Estimator::TruncatedLoss)>>
    : std::true_type {};

// The truncated loss of a model; gives up as soon as it exceeds bound.
template <typename Estimator>
double Score(const Estimator& estimator, const typename Estimator::Model& model,
             double squared_threshold, double bound) {
  if constexpr (HasTruncatedLoss<Estimator>::value) {
    return estimator.TruncatedLoss(model, squared_threshold, bound);
  } else {
    const double bound_scaled = bound * squared_threshold;
    double sum = 0.0;
    for (uint32_t i = 0; i < estimator.NumData() && sum <= bound_scaled; ++i) {
      sum += std::min(estimator.SquaredResidual(model, i), squared_threshold);
    }
    return sum / squared_threshold;
  }
}

template <typename Estimator>
std::vector<uint32_t> FindInliers(const Estimator& estimator,
                                  const typename Estimator::Model& model,
                                  double squared_threshold) {
  std::vector<uint32_t> inliers;
  for (uint32_t i = 0; i < estimator.NumData(); ++i) {
    if (estimator.SquaredResidual(model, i) < squared_threshold) inliers.push_back(i);
  }
  return inliers;
}

// Replaces the report's model where the candidate's score is lower.
template <typename Estimator>
bool TakeIfBetter(const Estimator& estimator, const typename Estimator::Model& candidate,
                  double squared_threshold, RansacReport<typename Estimator::Model>* report) {
  const double score = Score(estimator, candidate, squared_threshold, report->score);
  if (!(score < report->score)) return false;
  report->model = candidate;
  report->score = score;
  return true;
}

// Local optimisation (Chum 2003): fits the inliers again while that lowers the score.
template <typename Estimator>
void OptimizeLocally(const Estimator& estimator, double squared_threshold, int max_rounds,
                     RansacReport<typename Estimator::Model>* report) {
  for (int round = 0; round < max_rounds; ++round) {
    const std::vector<uint32_t> inliers = FindInliers(estimator, report->model, squared_threshold);
    const auto refined = estimator.Refine(report->model, inliers);
    if (!refined || !TakeIfBetter(estimator, *refined, squared_threshold, report)) return;
  }
}

}  // namespace ransac_internal

// RANSAC with truncated-loss score and local optimisation. An Estimator has
//   using Model; static constexpr int kSampleSize; uint32_t NumData() const;
//   std::vector<Model> Solve(const std::vector<uint32_t>& sample) const;
//   double SquaredResidual(const Model&, uint32_t datum) const;
//   std::optional<Model> Refine(const Model&, const std::vector<uint32_t>& inliers) const;
// and, where that can be faster than the sum over SquaredResidual,
//   double TruncatedLoss(const Model&, double squared_threshold, double bound) const;
// Nothing when there are fewer data than a sample, or no model has an inlier. The same data,
// options and state of rng give the same report.
template <typename Estimator>
std::optional<RansacReport<typename Estimator::Model>> Ransac(const Estimator& estimator,
                                                              const RansacOptions& options,
                                                              Rng& rng) {
  constexpr int kLocalRounds = 2;
  constexpr int kSampleSize = Estimator::kSampleSize;
  const uint32_t num_data = estimator.NumData();
  if (num_data < static_cast<uint32_t>(kSampleSize)) return std::nullopt;
  const double squared_threshold = options.threshold * options.threshold;
  RansacReport<typename Estimator::Model> report;
  report.score = num_data;
  std::vector<uint32_t> sample(kSampleSize);
  for (; report.num_iterations < options.max_iterations; ++report.num_iterations) {
    const uint32_t pool_size =
        ProsacPoolSize(num_data, kSampleSize, report.num_iterations, options.prosac_samples);
    if (HasDrawnEnough(report.num_iterations, report.inliers, pool_size, kSampleSize, options)) {
      break;
    }
    DrawSample(pool_size, rng, &sample);
    bool improved = false;
    for (const auto& model : estimator.Solve(sample)) {
      improved |= ransac_internal::TakeIfBetter(estimator, model, squared_threshold, &report);
    }
    if (!improved) continue;
    ransac_internal::OptimizeLocally(estimator, squared_threshold, kLocalRounds, &report);
    report.inliers = ransac_internal::FindInliers(estimator, report.model, squared_threshold);
  }
  if (report.inliers.empty()) return std::nullopt;
  return report;
}

}  // namespace rovio_sfm
