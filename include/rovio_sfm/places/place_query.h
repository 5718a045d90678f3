#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rovio_sfm/places/word_bag.h"

namespace rovio_sfm {

// An image to be recognised among the places of a Fabmap or TfIdf.
struct PlaceQuery {
  std::vector<uint32_t> words;            // one per feature, or a bag
  std::vector<uint32_t> excluded_places;  // never an answer: the recent past, other maps
  // Motion prior: relative weight of each place, not negative; empty at a drive's start: uniform.
  std::vector<double> place_weights;
};

// The `count` places of greatest value (or fewer), best first, the lower id of equals; places of
// value -infinity are left out.
std::vector<uint32_t> BestPlaces(const std::vector<double>& values, size_t count);

}  // namespace rovio_sfm
