#include "rovio_sfm/places/word_bag.h"

#include <algorithm>

namespace rovio_sfm {

WordBag BagOfWords(const std::vector<uint32_t>& words) {
  WordBag bag = words;
  std::sort(bag.begin(), bag.end());
  bag.erase(std::unique(bag.begin(), bag.end()), bag.end());
  return bag;
}

}  // namespace rovio_sfm
