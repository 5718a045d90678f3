#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/util/executor.h"
#include "rovio_sfm/util/option_table.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {

// k-means over descriptors, all in whole numbers: words are bytes, sums exact, so the result
// depends neither on threads nor on order of summation.
struct ClusterOptions {
  int num_words = 5000;
  int max_iterations = 12;
  double min_gain = 0.0005;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("num_words", num_words, 2, 65536, "");
    table.AddNumber("max_iterations", max_iterations, 0, 1000, "");
    table.AddNumber("min_gain", min_gain, 0.0, 1.0, "of the mean squared distance, or it stops");
  }
};

// Where the clustering stands; all that is needed to go on.
struct ClusterState {
  uint32_t num_iterations = 0;
  bool converged = false;
  Descriptors words;
  double mean_squared_distance = 0.0;  // from features to the words before the last iteration
};

// The first words: features far from each other, drawn with probability proportional to the squared
// distance to the words drawn before (k-means++), in growing batches, from a sample of the
// features. If there are fewer distinct features than words, some words are equal.
ClusterState SeedWords(const Descriptors& features, const ClusterOptions& options, Rng* rng);

// One iteration of Lloyd: each word moves to the mean, rounded, of the features nearest to it; a
// word without features to one of those farthest from theirs.
ClusterState ImproveWords(const Descriptors& features, const ClusterState& state,
                          const ClusterOptions& options, Executor* executor);

// Seeds (or goes on from `resumed`) and improves until converged, calling after_iteration after
// each step. Stopping anywhere and resuming gives the same words. features: metric L2, not empty.
ClusterState ClusterWords(const Descriptors& features, const ClusterOptions& options,
                          std::optional<ClusterState> resumed, Rng* rng, Executor* executor,
                          const std::function<void(const ClusterState&)>& after_iteration);

}  // namespace rovio_sfm
