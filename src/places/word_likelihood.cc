#include "rovio_sfm/places/word_likelihood.h"

#include <cmath>

namespace rovio_sfm {
namespace {

double ProbabilityOf(bool value, double p_true) { return value ? p_true : 1.0 - p_true; }

// p(z | e, parent's z) from p(z | e) and p(z | parent's z), normalised over z.
double ProbabilityGivenBoth(bool z, double p_z, double p_z_given_e, double p_z_given_parent) {
  const auto term = [&](bool value) {
    return ProbabilityOf(!value, p_z) * ProbabilityOf(value, p_z_given_e) *
           ProbabilityOf(value, p_z_given_parent);
  };
  return term(z) / (term(z) + term(!z));
}

}  // namespace

WordLikelihood LikelihoodOfWord(const ChowLiuNode& node, const DetectorOptions& options) {
  const WordDetector detector = DetectorOfWord(options, node.p_z);
  const double p_e_if_seen = detector.p_z_given_e * detector.p_e / node.p_z;
  const double p_e_if_not_seen = (1.0 - detector.p_z_given_e) * detector.p_e / (1.0 - node.p_z);
  WordLikelihood likelihood{};
  for (const bool z : {false, true}) {
    for (const bool parent_z : {false, true}) {
      const double p_parent = parent_z ? node.p_z_given_parent_true : node.p_z_given_parent_false;
      const double p_exists = ProbabilityGivenBoth(z, node.p_z, detector.p_z_given_e, p_parent);
      const double p_absent = ProbabilityGivenBoth(z, node.p_z, detector.p_z_given_not_e, p_parent);
      const auto log_mix = [&](double p_e) {
        return std::log(p_exists * p_e + p_absent * (1.0 - p_e));
      };
      likelihood.log_if_seen[z][parent_z] = log_mix(p_e_if_seen);
      likelihood.log_if_not_seen[z][parent_z] = log_mix(p_e_if_not_seen);
      likelihood.log_if_average[z][parent_z] = log_mix(detector.p_e);
    }
  }
  return likelihood;
}

LikelihoodTable::LikelihoodTable(const ChowLiuTree& tree, const DetectorOptions& detector)
    : child_begins_(tree.size() + 1, 0), children_(tree.size()) {
  for (const ChowLiuNode& node : tree) {
    words_.push_back(LikelihoodOfWord(node, detector));
    parents_.push_back(node.parent);
    empty_offset_ += words_.back().log_if_not_seen[0][0];
    empty_average_ += words_.back().log_if_average[0][0];
    if (node.parent != kNoParent) ++child_begins_[node.parent + 1];
  }
  for (size_t word = 0; word < tree.size(); ++word) child_begins_[word + 1] += child_begins_[word];
  std::vector<uint32_t> ends(child_begins_.begin(), child_begins_.end() - 1);
  for (uint32_t word = 0; word < tree.size(); ++word) {
    if (parents_[word] != kNoParent) children_[ends[parents_[word]]++] = word;
  }
}

double LikelihoodTable::ConstantOfBag(const WordBag& place) const {
  double sum = 0.0;
  for (const uint32_t word : place) {
    sum += words_[word].log_if_seen[0][0] - words_[word].log_if_not_seen[0][0];
  }
  return sum;
}

ObservationWeights LikelihoodTable::WeightsOf(const WordBag& observation) const {
  WordBag touched = observation;
  for (const uint32_t word : observation) {
    touched.insert(touched.end(), children_.begin() + child_begins_[word],
                   children_.begin() + child_begins_[word + 1]);
  }
  touched = BagOfWords(touched);
  std::vector<bool> seen(words_.size(), false);
  for (const uint32_t word : observation) seen[word] = true;

  ObservationWeights result{empty_offset_, empty_average_, {}};
  result.weights.reserve(touched.size());
  for (const uint32_t word : touched) {
    const WordLikelihood& of_word = words_[word];
    const bool z = seen[word], parent_z = parents_[word] != kNoParent && seen[parents_[word]];
    const double offset = of_word.log_if_not_seen[z][parent_z] - of_word.log_if_not_seen[0][0];
    const double if_seen = of_word.log_if_seen[z][parent_z] - of_word.log_if_seen[0][0];
    result.offset += offset;
    result.average += of_word.log_if_average[z][parent_z] - of_word.log_if_average[0][0];
    result.weights.push_back({word, if_seen - offset});
  }
  return result;
}

}  // namespace rovio_sfm
