#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/places/word_bag.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

constexpr uint32_t kNoParent = 0xffffffffu;

// A word in the Chow-Liu tree: p(z = 1), and the same given whether the parent word is present. The
// root has no parent; both conditionals are then p_z. All probabilities lie inside (0, 1).
struct ChowLiuNode {
  uint32_t parent = kNoParent;
  double p_z = 0.5;
  double p_z_given_parent_true = 0.5;
  double p_z_given_parent_false = 0.5;
};

// One node a word.
using ChowLiuTree = std::vector<ChowLiuNode>;

// How the tree's probabilities are taken from counts.
struct ChowLiuOptions {
  double pseudo_images = 1.0;

  void DescribeOptions(OptionTable& table) {
    // So that no count is 0 or 1, and words seen once are not bound to each other.
    table.AddNumber("pseudo_images", pseudo_images, 0.01, 1000.0,
                    "images' worth of independent words mixed into the counts");
  }
};

// The tree with the greatest sum of mutual information between the words of the bags (Chow and Liu
// 1968): a maximum spanning tree over all pairs, rooted at the most frequent word; the first of
// equals everywhere. Needs a bag; time grows with the square of num_words. Words of the bags are
// below num_words.
ChowLiuTree LearnChowLiuTree(const std::vector<WordBag>& bags, size_t num_words,
                             const ChowLiuOptions& options);

// True if every parent exists, all words hang from one root, and all probabilities lie in (0, 1);
// else error (may be null) names the node and its value.
bool IsValidTree(const ChowLiuTree& tree, std::string* error);

}  // namespace rovio_sfm
