#include "rovio_sfm/places/tf_idf.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {

TfIdf::TfIdf(const PlaceModel& model)
    : idf_(model.vocabulary.NumWords(), 0.0), index_(model.vocabulary.NumWords()) {
  std::vector<double> counts(idf_.size(), 0.0);
  for (const WordBag& bag : model.training_bags) {
    for (const uint32_t word : bag) counts[word] += 1.0;
  }
  const double num_images = static_cast<double>(model.training_bags.size()) + 1.0;
  for (size_t word = 0; word < idf_.size(); ++word) {
    idf_[word] = std::log(num_images / std::max(counts[word], 1.0));
  }
}

double TfIdf::NormOf(const WordBag& bag) const {
  double sum = 0.0;
  for (const uint32_t word : bag) sum += idf_[word] * idf_[word];
  return std::sqrt(sum);
}

uint32_t TfIdf::AddPlace(const std::vector<uint32_t>& words) {
  const WordBag bag = BagOfWords(words);
  const uint32_t place = index_.AddPlace(bag);
  norms_.push_back(NormOf(bag));
  return place;
}

TfIdfResult TfIdf::Query(const PlaceQuery& query) const {
  const WordBag bag = BagOfWords(query.words);
  ROVIO_CHECK(bag.empty() || bag.back() < idf_.size());
  std::vector<WordWeight> weights;
  for (const uint32_t word : bag) weights.push_back({word, idf_[word] * idf_[word]});
  TfIdfResult result;
  result.similarities.assign(NumPlaces(), 0.0);
  index_.AddWeights(weights, &result.similarities);
  const double norm = NormOf(bag);
  for (size_t place = 0; place < NumPlaces(); ++place) {
    const double both = norm * norms_[place];
    result.similarities[place] = both > 0.0 ? result.similarities[place] / both : 0.0;
  }
  result.score = -std::numeric_limits<double>::infinity();
  for (const uint32_t place : query.excluded_places) result.similarities.at(place) = result.score;
  for (const double similarity : result.similarities) {
    result.score = std::max(result.score, similarity);
  }
  return result;
}

}  // namespace rovio_sfm
