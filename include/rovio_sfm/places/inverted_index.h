#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rovio_sfm/places/word_bag.h"

namespace rovio_sfm {

struct WordWeight {
  uint32_t word = 0;
  double weight = 0.0;
};

// For each word the places that show it, in blocks of 256 places, a byte a posting; the newest,
// unfinished block keeps its places' bags. One writer or many readers.
class InvertedIndex {
 public:
  explicit InvertedIndex(size_t num_words);

  // The new place's id, counted from 0. Words are below num_words.
  uint32_t AddPlace(const WordBag& bag);

  size_t NumWords() const { return num_words_; }
  size_t NumPlaces() const { return blocks_.size() * kBlockPlaces + open_bags_.size(); }
  size_t NumBytes() const;  // memory held

  // Adds to sums[place] the weights of the words that the place shows, in the weights' order; sums
  // has one entry a place. Costs the postings of these words.
  void AddWeights(const std::vector<WordWeight>& weights, std::vector<double>* sums) const;

 private:
  static constexpr size_t kBlockPlaces = 256;

  // Places of the block that show word w: places[begins[w]] … places[begins[w + 1] - 1].
  struct Block {
    std::vector<uint32_t> begins;
    std::vector<uint8_t> places;
  };

  Block CloseBlock() const;
  void AddOpenWeights(const std::vector<WordWeight>& weights, double* sums) const;

  size_t num_words_;
  std::vector<Block> blocks_;
  std::vector<WordBag> open_bags_;
};

}  // namespace rovio_sfm
