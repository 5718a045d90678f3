#include "rovio_sfm/matching/match_approximate.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/flann.hpp>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

cv::Mat FloatRows(const Descriptors& descriptors) {
  const cv::Mat bytes(static_cast<int>(descriptors.Count()), static_cast<int>(descriptors.length),
                      CV_8U, const_cast<uint8_t*>(descriptors.data.data()));
  cv::Mat floats;
  bytes.convertTo(floats, CV_32F);
  return floats;
}

// FLANN draws from the thread's generator of OpenCV; it is put back afterwards.
class SeededRng {
 public:
  explicit SeededRng(uint64_t seed) : saved_(cv::theRNG()) { cv::theRNG() = cv::RNG(seed); }
  ~SeededRng() { cv::theRNG() = saved_; }
  SeededRng(const SeededRng&) = delete;
  SeededRng& operator=(const SeededRng&) = delete;

 private:
  cv::RNG saved_;
};

void BuildIndex(const cv::Mat& rows, const MatchOptions& options, cv::flann::Index* index) {
  if (options.matcher == Matcher::kKMeansTree) {
    index->build(rows, cv::flann::KMeansIndexParams(std::min(options.branching, rows.rows)));
  } else {
    index->build(rows, cv::flann::KDTreeIndexParams(options.trees));
  }
}

}  // namespace

std::vector<FeatureMatch> MatchApproximately(const Descriptors& a, const Descriptors& b,
                                             const MatchOptions& options) {
  ROVIO_CHECK(a.length == b.length && a.metric == DescriptorMetric::kL2);
  const cv::Mat rows_a = FloatRows(a), rows_b = FloatRows(b);
  const int num_neighbours = std::min(2, rows_a.rows);
  cv::Mat indices, squared;
  const SeededRng seeded(options.seed);
  cv::flann::Index index;
  BuildIndex(rows_a, options, &index);
  index.knnSearch(rows_b, indices, squared, num_neighbours,
                  cv::flann::SearchParams(options.checks));
  std::vector<FeatureMatch> matches;
  for (int row = 0; row < rows_b.rows; ++row) {
    const int nearest = indices.at<int>(row, 0);
    if (nearest < 0 || nearest >= rows_a.rows) continue;
    FeatureMatch match{static_cast<uint32_t>(nearest), static_cast<uint32_t>(row), 0.0f, 1.0f};
    match.distance = std::sqrt(squared.at<float>(row, 0));
    if (num_neighbours == 2 && squared.at<float>(row, 1) > 0.0f) {
      match.ratio = match.distance / std::sqrt(squared.at<float>(row, 1));
    }
    matches.push_back(match);
  }
  return matches;
}

}  // namespace rovio_sfm
