#include "rovio_sfm/places/inverted_index.h"

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {

InvertedIndex::InvertedIndex(size_t num_words) : num_words_(num_words) {}

uint32_t InvertedIndex::AddPlace(const WordBag& bag) {
  const auto place = static_cast<uint32_t>(NumPlaces());
  ROVIO_CHECK(bag.empty() || bag.back() < num_words_);
  open_bags_.push_back(bag);
  open_bags_.back().shrink_to_fit();
  if (open_bags_.size() == kBlockPlaces) {
    blocks_.push_back(CloseBlock());
    open_bags_.clear();
  }
  return place;
}

InvertedIndex::Block InvertedIndex::CloseBlock() const {
  Block block;
  block.begins.assign(num_words_ + 1, 0);
  for (const WordBag& bag : open_bags_) {
    for (const uint32_t word : bag) ++block.begins[word + 1];
  }
  for (size_t word = 0; word < num_words_; ++word) block.begins[word + 1] += block.begins[word];
  block.places.resize(block.begins.back());
  std::vector<uint32_t> ends(block.begins.begin(), block.begins.end() - 1);
  for (size_t place = 0; place < open_bags_.size(); ++place) {
    for (const uint32_t word : open_bags_[place]) {
      block.places[ends[word]++] = static_cast<uint8_t>(place);
    }
  }
  return block;
}

size_t InvertedIndex::NumBytes() const {
  size_t bytes = blocks_.capacity() * sizeof(Block) + open_bags_.capacity() * sizeof(WordBag);
  for (const Block& block : blocks_) {
    bytes += block.begins.capacity() * sizeof(uint32_t) + block.places.capacity();
  }
  for (const WordBag& bag : open_bags_) bytes += bag.capacity() * sizeof(uint32_t);
  return bytes;
}

void InvertedIndex::AddWeights(const std::vector<WordWeight>& weights,
                               std::vector<double>* sums) const {
  ROVIO_CHECK(sums->size() == NumPlaces());
  double* block_sums = sums->data();
  for (const Block& block : blocks_) {
    for (const WordWeight& weight : weights) {
      const uint8_t* const end = block.places.data() + block.begins[weight.word + 1];
      for (const uint8_t* place = block.places.data() + block.begins[weight.word]; place != end;
           ++place) {
        block_sums[*place] += weight.weight;
      }
    }
    block_sums += kBlockPlaces;
  }
  AddOpenWeights(weights, block_sums);
}

// As many places are few, a table of all words is the quickest; sums come in the same order.
void InvertedIndex::AddOpenWeights(const std::vector<WordWeight>& weights, double* sums) const {
  if (open_bags_.empty()) return;
  std::vector<double> weight_of_word(num_words_, 0.0);
  for (const WordWeight& weight : weights) weight_of_word[weight.word] += weight.weight;
  for (size_t place = 0; place < open_bags_.size(); ++place) {
    for (const uint32_t word : open_bags_[place]) sums[place] += weight_of_word[word];
  }
}

}  // namespace rovio_sfm
