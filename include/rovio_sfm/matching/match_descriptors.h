#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/match.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

enum class Matcher : uint8_t {
  kExact,       // brute force, as matrix products
  kKdTree,      // FLANN, randomised kd-trees; L2 only, Hamming falls to exact
  kKMeansTree,  // FLANN, hierarchical k-means; L2 only, Hamming falls to exact
};

struct MatchOptions {
  Matcher matcher = Matcher::kExact;
  int trees = 4;
  int branching = 32;
  int checks = 64;
  uint64_t seed = 1;

  void DescribeOptions(OptionTable& table) {
    table.AddChoice("matcher", matcher,
                    {{"exact", Matcher::kExact},
                     {"kdtree", Matcher::kKdTree},
                     {"kmeans_tree", Matcher::kKMeansTree}},
                    "finds the nearest descriptors");
    table.AddNumber("trees", trees, 1, 16, "of kdtree");
    table.AddNumber("branching", branching, 2, 256, "of kmeans_tree");
    table.AddNumber("checks", checks, 1, 10000, "leaves visited per query");
    table.AddNumber("seed", seed, 0, kNoLimit, "of the trees");
  }
};

// For each descriptor of b its nearest of a, with the distance and the ratio to the second nearest
// (1 where there is no second; 0/0 counts as 1), in order of b; equal distances go to the smaller
// a. Empty if either is empty or the types differ. No filter is applied. The first call sets
// OpenBLAS to one thread for the whole process. Pure otherwise; exact results are whole-number
// arithmetic.
std::vector<FeatureMatch> MatchDescriptors(const Descriptors& a, const Descriptors& b,
                                           const MatchOptions& options);

}  // namespace rovio_sfm
