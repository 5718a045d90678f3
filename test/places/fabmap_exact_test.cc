// FAB-MAP against full enumeration: every state e of all words is summed, for every observation of
// a small vocabulary.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "places/random_place_model.h"
#include "rovio_sfm/places/fabmap.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kWords = 5;
constexpr uint32_t kStates = 1u << kWords;  // of all words, a bit a word

bool Bit(uint32_t state, uint32_t word) { return (state >> word & 1) != 0; }

uint32_t StateOf(const WordBag& bag) {
  uint32_t state = 0;
  for (const uint32_t word : bag) state |= 1u << word;
  return state;
}

WordBag BagOf(uint32_t state) {
  WordBag bag;
  for (uint32_t word = 0; word < kWords; ++word) {
    if (Bit(state, word)) bag.push_back(word);
  }
  return bag;
}

double Pick(bool value, double p) { return value ? p : 1.0 - p; }

// The generative model, written a second time, straight from the paper.
class Enumeration {
 public:
  explicit Enumeration(const PlaceModel& model) : model_(model) {}

  // p(e_q = 1) of a place where z_q was `seen`, by Bayes' rule.
  double PriorExistence(uint32_t q) const { return Detector(q).p_e; }
  double Existence(uint32_t q, bool seen) const {
    const WordDetector detector = Detector(q);
    const double yes = Pick(seen, detector.p_z_given_e) * detector.p_e;
    const double no = Pick(seen, detector.p_z_given_not_e) * (1.0 - detector.p_e);
    return yes / (yes + no);
  }

  // p(Z | existence of each word), summed over all e.
  double Likelihood(uint32_t z, const std::vector<double>& existence) const {
    double sum = 0.0;
    for (uint32_t e = 0; e < kStates; ++e) {
      double product = 1.0;
      for (uint32_t q = 0; q < kWords; ++q) {
        product *= Pick(Bit(e, q), existence[q]) * Observation(q, z, Bit(e, q));
      }
      sum += product;
    }
    return sum;
  }

  double AtPlace(uint32_t z, const WordBag& place) const {
    std::vector<double> existence;
    for (uint32_t q = 0; q < kWords; ++q) existence.push_back(Existence(q, Bit(StateOf(place), q)));
    return Likelihood(z, existence);
  }

  double AtNewPlace(uint32_t z, NewPlaceModel kind) const {
    if (kind == NewPlaceModel::kMeanField) {
      std::vector<double> existence;
      for (uint32_t q = 0; q < kWords; ++q) existence.push_back(PriorExistence(q));
      return Likelihood(z, existence);
    }
    double sum = 0.0;
    for (const WordBag& bag : model_.training_bags) sum += AtPlace(z, bag);
    return sum / static_cast<double>(model_.training_bags.size());
  }

 private:
  WordDetector Detector(uint32_t q) const {
    return DetectorOfWord(model_.detector, model_.tree[q].p_z);
  }

  // p(z_q | e_q, z_pq) = 1 / (1 + alpha / beta).
  double Observation(uint32_t q, uint32_t z, bool e) const {
    const ChowLiuNode& node = model_.tree[q];
    const WordDetector detector = Detector(q);
    const double p_given_e = e ? detector.p_z_given_e : detector.p_z_given_not_e;
    if (node.parent == kNoParent) return Pick(Bit(z, q), p_given_e);
    const double p_given_parent =
        Bit(z, node.parent) ? node.p_z_given_parent_true : node.p_z_given_parent_false;
    const bool seen = Bit(z, q);
    const double alpha =
        Pick(seen, node.p_z) * Pick(!seen, p_given_e) * Pick(!seen, p_given_parent);
    const double beta = Pick(!seen, node.p_z) * Pick(seen, p_given_e) * Pick(seen, p_given_parent);
    return beta / (alpha + beta);
  }

  const PlaceModel& model_;
};

class FabmapExact : public testing::TestWithParam<NewPlaceModel> {
 protected:
  FabmapExact() : model_(SharedRandomPlaceModel(kWords, 20, 11)), fabmap_(model_, {GetParam()}) {
    Rng rng(12);
    places_ = RandomBags(6, kWords, &rng);
    for (const WordBag& place : places_) fabmap_.AddPlace(place);
  }

  std::shared_ptr<const PlaceModel> model_;
  Fabmap fabmap_;
  std::vector<WordBag> places_;
};

TEST_P(FabmapExact, PosteriorIsThatOfFullEnumeration) {
  const Enumeration exact(*model_);
  const std::vector<double> weights = {1.0, 0.5, 0.0, 2.0, 1.0, 0.25};
  const double sum_of_weights = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (uint32_t z = 0; z < kStates; ++z) {
    const FabmapResult result = fabmap_.Query({BagOf(z), {}, weights});
    const double at_new = 0.9 * exact.AtNewPlace(z, GetParam());
    double evidence = at_new, sum = 0.0;
    for (size_t i = 0; i < places_.size(); ++i) {
      sum += exact.AtPlace(z, places_[i]);
      evidence += 0.1 * weights[i] / sum_of_weights * exact.AtPlace(z, places_[i]);
    }
    EXPECT_NEAR(result.new_place_posterior, at_new / evidence, 1e-12);
    EXPECT_NEAR(result.score, std::log(sum / exact.AtNewPlace(z, GetParam())), 1e-10);
    for (size_t i = 0; i < places_.size(); ++i) {
      const double at_place = exact.AtPlace(z, places_[i]);
      EXPECT_NEAR(result.log_likelihoods[i], std::log(at_place), 1e-10);
      EXPECT_NEAR(result.posteriors[i], 0.1 * weights[i] / sum_of_weights * at_place / evidence,
                  1e-12);
    }
  }
}

TEST_P(FabmapExact, ObservationsOfAPlaceAddUpToCertainty) {
  std::vector<double> sums(places_.size(), 0.0);
  double sum_at_new = 0.0;
  for (uint32_t z = 0; z < kStates; ++z) {
    const FabmapResult result = fabmap_.Query({BagOf(z), {}, {}});
    for (size_t i = 0; i < sums.size(); ++i) sums[i] += std::exp(result.log_likelihoods[i]);
    sum_at_new += std::exp(result.new_place_log_likelihood);
  }
  for (const double sum : sums) EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_NEAR(sum_at_new, 1.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(BothNewPlaceModels, FabmapExact,
                         testing::Values(NewPlaceModel::kMeanField, NewPlaceModel::kSampled));

}  // namespace
}  // namespace rovio_sfm
