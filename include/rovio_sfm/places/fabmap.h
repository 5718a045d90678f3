#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "rovio_sfm/places/inverted_index.h"
#include "rovio_sfm/places/place_model.h"
#include "rovio_sfm/places/place_query.h"
#include "rovio_sfm/places/word_likelihood.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// How likely an image is in a place never seen: in the average place, or in the mean over the
// training images taken as places.
enum class NewPlaceModel { kMeanField, kSampled };

struct FabmapOptions {
  NewPlaceModel new_place_model = NewPlaceModel::kSampled;
  double new_place_prior = 0.9;

  void DescribeOptions(OptionTable& table) {
    table.AddChoice(
        "new_place_model", new_place_model,
        {{"mean_field", NewPlaceModel::kMeanField}, {"sampled", NewPlaceModel::kSampled}},
        "what an image of a new place looks like");
    table.AddNumber("new_place_prior", new_place_prior, 0.001, 0.999, "of a place never seen");
  }
};

// What an image says about where it was taken. Rank by score and let geometry decide: posteriors
// saturate, and neighbouring places share theirs.
struct FabmapResult {
  std::vector<double> log_likelihoods;    // log p(Z | place) for each place; excluded: -infinity
  std::vector<double> posteriors;         // p(place | Z); excluded: 0
  double new_place_log_likelihood = 0.0;  // log p(Z | a place never seen)
  double new_place_posterior = 1.0;       // with the posteriors the sum is 1
  double score = 0.0;  // log(sum of p(Z | place) / p(Z | new place)); -infinity without places
};

// FAB-MAP 2.0 (Cummins and Newman 2011): place recognition by appearance, each image a place. A
// query costs the postings of its words and of their children in the tree, and one pass over the
// places. One writer or many readers; the same calls give the same bytes.
class Fabmap {
 public:
  Fabmap(std::shared_ptr<const PlaceModel> model, const FabmapOptions& options);

  // Takes in an image as a place: its id, counted from 0. words as from Vocabulary::Quantize.
  uint32_t AddPlace(const std::vector<uint32_t>& words);
  FabmapResult Query(const PlaceQuery& query) const;

  const PlaceModel& Model() const { return *model_; }
  size_t NumPlaces() const { return index_.NumPlaces(); }
  size_t NumBytes() const;  // memory that grows with the places

 private:
  double NewPlaceLogLikelihood(const ObservationWeights& observation) const;

  std::shared_ptr<const PlaceModel> model_;
  FabmapOptions options_;
  LikelihoodTable table_;
  InvertedIndex index_;
  std::vector<double> constants_;  // of each place
  InvertedIndex samples_;          // the training images as places
  std::vector<double> sample_constants_;
};

}  // namespace rovio_sfm
