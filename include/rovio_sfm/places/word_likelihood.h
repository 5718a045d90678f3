#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rovio_sfm/places/chow_liu_tree.h"
#include "rovio_sfm/places/detector_model.h"
#include "rovio_sfm/places/inverted_index.h"

namespace rovio_sfm {

// log p(z | parent's z, place) of one word, for a place where it was seen or was not, and for the
// average place (mean field). Indices: [z][z of the parent]; a root ignores the second.
struct WordLikelihood {
  double log_if_seen[2][2];
  double log_if_not_seen[2][2];
  double log_if_average[2][2];
};

// From a node of the tree and the detector (Cummins and Newman 2008, eq. 10 to 14): the sum over e
// of p(z | e, parent's z) p(e | place).
WordLikelihood LikelihoodOfWord(const ChowLiuNode& node, const DetectorOptions& detector);

// An observation Z as a linear function of a place's bag B: log p(Z | place) = offset
// + sum over B of the word's constant (LikelihoodTable::ConstantOfBag) + sum over B of weights.
struct ObservationWeights {
  double offset = 0.0;
  double average = 0.0;             // log p(Z | average place), mean field
  std::vector<WordWeight> weights;  // words of Z and their children in the tree, ascending
};

// The likelihoods of all words of a tree. Immutable.
class LikelihoodTable {
 public:
  LikelihoodTable(const ChowLiuTree& tree, const DetectorOptions& detector);

  size_t NumWords() const { return words_.size(); }
  // The part of log p(Z | place) that every observation shares.
  double ConstantOfBag(const WordBag& place) const;
  // What Z adds to that; costs its words and their children.
  ObservationWeights WeightsOf(const WordBag& observation) const;

 private:
  std::vector<WordLikelihood> words_;
  std::vector<uint32_t> parents_;
  std::vector<uint32_t> child_begins_;  // children of w: children_[child_begins_[w]] …
  std::vector<uint32_t> children_;
  double empty_offset_ = 0.0;  // offset and average of an observation without words
  double empty_average_ = 0.0;
};

}  // namespace rovio_sfm
