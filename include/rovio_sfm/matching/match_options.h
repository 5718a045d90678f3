#pragma once

#include <cstdint>
#include <string>

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

}  // namespace rovio_sfm
