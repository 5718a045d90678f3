#include "rovio_sfm/places/vocabulary.h"

#include <utility>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

constexpr int kNumAxes = 23;       // more cost more than they rule out
constexpr float kRounding = 2.0f;  // of squared distances below 2^24, generously

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

int SquaredDistance(const uint8_t* a, const uint8_t* b, uint32_t length) {
  int sum = 0;
  for (uint32_t i = 0; i < length; ++i) {
    const int difference = int{a[i]} - int{b[i]};
    sum += difference * difference;
  }
  return sum;
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
    : words_(std::move(words)), axes_(words_, kNumAxes), short_words_(axes_.Shorten(words_)) {}

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
  const FloatRows shortened = axes_.Shorten(descriptors);
  std::vector<uint32_t> words(descriptors.Count());
  ForEachProductRow(short_words_, shortened, [&](size_t i, const float* products) {
    words[i] = NearestWord(descriptors.Row(i), products, shortened.squared_norms[i]);
  });
  return words;
}

// products: of the shortened words with the shortened descriptor; squared_norm: of that about the
// mean.
uint32_t Vocabulary::NearestWord(const uint8_t* descriptor, const float* products,
                                 float squared_norm) const {
  const std::vector<float>& norms = short_words_.squared_norms;
  uint32_t best = 0;
  int least = SquaredDistance(descriptor, words_.Row(0), words_.length);
  const auto too_far = [&] { return squared_norm - static_cast<float>(least) - kRounding; };
  float limit = too_far();
  for (uint32_t i = 1; i < norms.size(); ++i) {
    if (2.0f * products[i] - norms[i] < limit) continue;
    const int distance = SquaredDistance(descriptor, words_.Row(i), words_.length);
    if (distance >= least) continue;
    best = i;
    least = distance;
    limit = too_far();
  }
  return best;
}

}  // namespace rovio_sfm
