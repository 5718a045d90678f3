#include "rovio_sfm/places/fabmap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

constexpr double kMinusInfinity = -std::numeric_limits<double>::infinity();

// log(sum of exp); -infinity for nothing.
double LogSumExp(const std::vector<double>& logs) {
  if (logs.empty()) return kMinusInfinity;
  const double greatest = *std::max_element(logs.begin(), logs.end());
  if (greatest == kMinusInfinity) return kMinusInfinity;
  double sum = 0.0;
  for (const double value : logs) sum += std::exp(value - greatest);
  return greatest + std::log(sum);
}

std::vector<double> LogLikelihoods(const ObservationWeights& observation,
                                   const InvertedIndex& index,
                                   const std::vector<double>& constants) {
  std::vector<double> sums = constants;
  for (double& sum : sums) sum += observation.offset;
  index.AddWeights(observation.weights, &sums);
  return sums;
}

// log prior of each place; -infinity for places that cannot be.
std::vector<double> LogPriors(const PlaceQuery& query, const std::vector<double>& log_likelihoods,
                              double total) {
  std::vector<double> priors = query.place_weights;
  if (priors.empty()) priors.assign(log_likelihoods.size(), 1.0);
  for (size_t place = 0; place < priors.size(); ++place) {
    if (log_likelihoods[place] == kMinusInfinity) priors[place] = 0.0;
  }
  const double sum = std::accumulate(priors.begin(), priors.end(), 0.0);
  for (double& prior : priors) prior = sum > 0.0 ? std::log(total * prior / sum) : kMinusInfinity;
  return priors;
}

// Bayes' rule over the places and the new place.
void SetPosteriors(const PlaceQuery& query, double new_place_prior, FabmapResult* result) {
  std::vector<double> logs = LogPriors(query, result->log_likelihoods, 1.0 - new_place_prior);
  for (size_t place = 0; place < logs.size(); ++place) {
    if (logs[place] != kMinusInfinity) logs[place] += result->log_likelihoods[place];
  }
  const bool any =
      std::any_of(logs.begin(), logs.end(), [](double v) { return v > kMinusInfinity; });
  logs.push_back((any ? std::log(new_place_prior) : 0.0) + result->new_place_log_likelihood);
  const double evidence = LogSumExp(logs);
  for (double& value : logs) value = std::exp(value - evidence);
  result->new_place_posterior = logs.back();
  logs.pop_back();
  result->posteriors = std::move(logs);
}

}  // namespace

Fabmap::Fabmap(std::shared_ptr<const PlaceModel> model, const FabmapOptions& options)
    : model_(std::move(model)),
      options_(options),
      table_(model_->tree, model_->detector),
      index_(model_->tree.size()),
      samples_(model_->tree.size()) {
  for (const WordBag& bag : model_->training_bags) {
    samples_.AddPlace(bag);
    sample_constants_.push_back(table_.ConstantOfBag(bag));
  }
}

uint32_t Fabmap::AddPlace(const std::vector<uint32_t>& words) {
  const WordBag bag = BagOfWords(words);
  const uint32_t place = index_.AddPlace(bag);
  constants_.push_back(table_.ConstantOfBag(bag));
  return place;
}

FabmapResult Fabmap::Query(const PlaceQuery& query) const {
  const WordBag bag = BagOfWords(query.words);
  ROVIO_CHECK(bag.empty() || bag.back() < table_.NumWords());
  ROVIO_CHECK(query.place_weights.empty() || query.place_weights.size() == NumPlaces());
  const ObservationWeights observation = table_.WeightsOf(bag);
  FabmapResult result;
  result.log_likelihoods = LogLikelihoods(observation, index_, constants_);
  for (const uint32_t place : query.excluded_places) {
    result.log_likelihoods.at(place) = kMinusInfinity;
  }
  result.new_place_log_likelihood = NewPlaceLogLikelihood(observation);
  result.score = LogSumExp(result.log_likelihoods) - result.new_place_log_likelihood;
  SetPosteriors(query, options_.new_place_prior, &result);
  return result;
}

double Fabmap::NewPlaceLogLikelihood(const ObservationWeights& observation) const {
  if (options_.new_place_model == NewPlaceModel::kMeanField || sample_constants_.empty()) {
    return observation.average;
  }
  const std::vector<double> samples = LogLikelihoods(observation, samples_, sample_constants_);
  return LogSumExp(samples) - std::log(static_cast<double>(samples.size()));
}

size_t Fabmap::NumBytes() const {
  return index_.NumBytes() + constants_.capacity() * sizeof(double);
}

}  // namespace rovio_sfm
