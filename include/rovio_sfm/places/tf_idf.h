#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "rovio_sfm/places/inverted_index.h"
#include "rovio_sfm/places/place_model.h"
#include "rovio_sfm/places/place_query.h"

namespace rovio_sfm {

struct TfIdfResult {
  std::vector<double> similarities;  // of each place, 0 to 1; excluded: -infinity
  double score = 0.0;                // the greatest similarity; -infinity without places
};

// The plain competitor of FAB-MAP on the same vocabulary: cosine between vectors of words present
// or absent (counts do worse), weighted by log(training images / images with the word). Ignores the
// motion prior. One writer or many readers.
class TfIdf {
 public:
  explicit TfIdf(const PlaceModel& model);

  uint32_t AddPlace(const std::vector<uint32_t>& words);
  TfIdfResult Query(const PlaceQuery& query) const;
  size_t NumPlaces() const { return index_.NumPlaces(); }

 private:
  double NormOf(const WordBag& bag) const;

  std::vector<double> idf_;
  InvertedIndex index_;
  std::vector<double> norms_;  // of each place
};

}  // namespace rovio_sfm
