#include "rovio_sfm/places/vocabulary.h"

#include <utility>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

// Where 2 a·b - |a|² is greatest, that is, the distance least; the first of equals.
uint32_t NearestIndex(const FloatRows& centers, const float* products) {
  const std::vector<float>& norms = centers.squared_norms;
  uint32_t best = 0;
  float best_value = 2.0f * products[0] - norms[0];
  for (uint32_t i = 1; i < norms.size(); ++i) {
    const float value = 2.0f * products[i] - norms[i];
    if (value > best_value) {
      best_value = value;
      best = i;
    }
  }
  return best;
}

std::string NameOf(const Descriptors& descriptors) {
  return "type " + std::to_string(static_cast<int>(descriptors.type)) + " of " +
         std::to_string(descriptors.length) + " bytes";
}

}  // namespace

std::vector<NearestCenter> FindNearestCenters(const FloatRows& centers, const FloatRows& points) {
  ROVIO_CHECK(centers.Count() > 0);
  std::vector<NearestCenter> nearest(points.Count());
  ForEachProductRow(centers, points, [&](size_t point, const float* products) {
    const uint32_t best = NearestIndex(centers, products);
    nearest[point].index = best;
    nearest[point].squared_distance =
        points.squared_norms[point] + centers.squared_norms[best] - 2.0f * products[best];
  });
  return nearest;
}

Vocabulary::Vocabulary(Descriptors words)
    : words_(std::move(words)), nearest_(words_.data, words_.length) {
  ROVIO_CHECK(words_.metric == DescriptorMetric::kL2);
}

bool Vocabulary::Accepts(const Descriptors& descriptors, std::string* reason) const {
  if (descriptors.type == words_.type && descriptors.length == words_.length) return true;
  if (reason != nullptr) {
    *reason = "descriptors are of " + NameOf(descriptors) + ", the vocabulary's words of " +
              NameOf(words_);
  }
  return false;
}

std::vector<uint32_t> Vocabulary::Quantize(const Descriptors& descriptors) const {
  ROVIO_CHECK(Accepts(descriptors, nullptr));
  std::vector<uint32_t> words(descriptors.Count());
  nearest_.ForEachTwo(descriptors.data,
                      [&](size_t i, const NearestRows::Two& two) { words[i] = two.best; });
  return words;
}

}  // namespace rovio_sfm
