#include "rovio_sfm/matching/match_descriptors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>

#include "rovio_sfm/matching/descriptor_distance.h"
#include "rovio_sfm/matching/match_approximate.h"
#include "rovio_sfm/util/byte_products.h"
#include "rovio_sfm/util/nearest_rows.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMany = 2000;  // features; of fewer a full product costs less than the axes

struct BestTwo {
  size_t best = 0;
  float best_value = -std::numeric_limits<float>::infinity();
  float second_value = -std::numeric_limits<float>::infinity();
};

// Greatest 2 a·b - |a|², that is least distance; the first of equals.
BestTwo FindBestTwo(const float* products, const std::vector<float>& squared_norms) {
  BestTwo two;
  for (size_t i = 0; i < squared_norms.size(); ++i) {
    const float value = 2.0f * products[i] - squared_norms[i];
    if (value <= two.second_value) continue;
    if (value > two.best_value) {
      two.second_value = two.best_value;
      two.best_value = value;
      two.best = i;
    } else {
      two.second_value = value;
    }
  }
  return two;
}

// From squared distances; an infinite second: there is none.
FeatureMatch MakeMatch(size_t a, size_t b, float least, float second) {
  FeatureMatch match{static_cast<uint32_t>(a), static_cast<uint32_t>(b), std::sqrt(least), 1.0f};
  if (std::isfinite(second) && second > 0.0f) match.ratio = match.distance / std::sqrt(second);
  return match;
}

std::vector<FeatureMatch> MatchExactL2(const Descriptors& a, const Descriptors& b) {
  const FloatRows float_a = ToFloatRows(a.data, a.length);
  const FloatRows float_b = ToFloatRows(b.data, b.length);
  std::vector<FeatureMatch> matches;
  matches.reserve(b.Count());
  ForEachProductRow(float_a, float_b, [&](size_t index_b, const float* products) {
    const BestTwo two = FindBestTwo(products, float_a.squared_norms);
    const float norm = float_b.squared_norms[index_b];
    matches.push_back(MakeMatch(two.best, index_b, norm - two.best_value, norm - two.second_value));
  });
  return matches;
}

// The same, faster where there are many.
std::vector<FeatureMatch> MatchManyL2(const Descriptors& a, const Descriptors& b) {
  std::vector<FeatureMatch> matches;
  matches.reserve(b.Count());
  NearestRows(a.data, a.length)
      .ForEachTwo(b.data, [&](size_t index_b, const NearestRows::Two& two) {
        matches.push_back(MakeMatch(two.best, index_b, static_cast<float>(two.least),
                                    static_cast<float>(two.second)));
      });
  return matches;
}

cv::Mat ByteRows(const Descriptors& descriptors) {
  return cv::Mat(static_cast<int>(descriptors.Count()), static_cast<int>(descriptors.length), CV_8U,
                 const_cast<uint8_t*>(descriptors.data.data()));
}

std::vector<FeatureMatch> MatchExactHamming(const Descriptors& a, const Descriptors& b) {
  const int num_neighbours = a.Count() > 1 ? 2 : 1;
  cv::Mat distances, indices;
  cv::batchDistance(ByteRows(b), ByteRows(a), distances, CV_32S, indices, cv::NORM_HAMMING,
                    num_neighbours);
  std::vector<FeatureMatch> matches;
  for (int row = 0; row < distances.rows; ++row) {
    FeatureMatch match{static_cast<uint32_t>(indices.at<int>(row, 0)), static_cast<uint32_t>(row),
                       static_cast<float>(distances.at<int>(row, 0)), 1.0f};
    if (num_neighbours == 2 && distances.at<int>(row, 1) > 0) {
      match.ratio = match.distance / static_cast<float>(distances.at<int>(row, 1));
    }
    matches.push_back(match);
  }
  return matches;
}

}  // namespace

std::vector<FeatureMatch> MatchDescriptors(const Descriptors& a, const Descriptors& b,
                                           const MatchOptions& options) {
  if (a.Count() == 0 || b.Count() == 0) return {};
  if (!AreComparable(a, b)) return {};
  if (a.metric == DescriptorMetric::kHamming) return MatchExactHamming(a, b);
  if (options.matcher != Matcher::kExact) return MatchApproximately(a, b, options);
  return std::min(a.Count(), b.Count()) >= kMany ? MatchManyL2(a, b) : MatchExactL2(a, b);
}

}  // namespace rovio_sfm
