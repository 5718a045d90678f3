#pragma once

#include <cstdint>

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

}  // namespace rovio_sfm
