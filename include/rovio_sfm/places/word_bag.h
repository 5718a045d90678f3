#pragma once

#include <cstdint>
#include <vector>

namespace rovio_sfm {

// The distinct words of an image, ascending: what FAB-MAP calls Z, present or absent.
using WordBag = std::vector<uint32_t>;

// words: one per feature, as Vocabulary::Quantize gives them, in any order, repeated or not.
WordBag BagOfWords(const std::vector<uint32_t>& words);

}  // namespace rovio_sfm
