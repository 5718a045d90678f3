#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/match.h"

namespace rovio_sfm {

enum class Matcher : uint8_t {
  kExact,       // brute force, as matrix products
  kKdTree,      // FLANN, randomised kd-trees; L2 only, Hamming falls to exact
  kKMeansTree,  // FLANN, hierarchical k-means; L2 only, Hamming falls to exact
};

struct MatchOptions {
  Matcher matcher = Matcher::kExact;
  int trees = 4;       // kd-trees; 1 to 16
  int branching = 32;  // of the k-means tree; 2 to 256
  int checks = 64;     // leaves visited per query; 1 to 10000
  uint64_t seed = 1;   // of the trees

  bool IsValid(std::string* error) const;
};

// For each descriptor of b its nearest of a, with the distance and the ratio to the second nearest
// (1 where there is no second; 0/0 counts as 1), in order of b; equal distances go to the smaller
// a. Empty if either is empty or the types differ. No filter is applied. The first call sets
// OpenBLAS to one thread for the whole process. Pure otherwise; exact results are whole-number
// arithmetic.
std::vector<FeatureMatch> MatchDescriptors(const Descriptors& a, const Descriptors& b,
                                           const MatchOptions& options);

}  // namespace rovio_sfm
