#pragma once

#include <cstddef>
#include <vector>

#include "rovio_sfm/places/chow_liu_tree.h"
#include "rovio_sfm/places/word_bag.h"

namespace rovio_sfm {

// Two bags of words of one place.
struct BagPair {
  WordBag first;
  WordBag second;
};

// How often words are seen again where they were seen.
struct DetectorReport {
  size_t num_words = 0;      // looked for again
  double seen_again = 0.0;   // share of them
  double p_z_given_e = 0.0;  // beyond chance: what DetectorOfWord adds for frequent words taken off
};

// From pairs of looks at the same place and the words' shares of images in the tree. All zero
// without words.
DetectorReport MeasureDetector(const std::vector<BagPair>& pairs, const ChowLiuTree& tree);

}  // namespace rovio_sfm
