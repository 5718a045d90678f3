#include "rovio_sfm/features/select_keypoints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace rovio_sfm {
namespace {

std::vector<cv::KeyPoint> StrongestFirst(const std::vector<cv::KeyPoint>& keypoints,
                                         double size_exponent) {
  std::vector<std::pair<float, cv::KeyPoint>> ranked;  // by strength
  for (const cv::KeyPoint& keypoint : keypoints) {
    const float factor = std::pow(keypoint.size, static_cast<float>(size_exponent));
    ranked.emplace_back(keypoint.response * factor, keypoint);
  }
  std::sort(ranked.begin(), ranked.end(), [](const auto& x, const auto& y) {
    const cv::KeyPoint &a = x.second, &b = y.second;
    return std::make_tuple(-x.first, a.pt.y, a.pt.x, a.angle, a.size) <
           std::make_tuple(-y.first, b.pt.y, b.pt.x, b.angle, b.size);
  });
  std::vector<cv::KeyPoint> sorted;
  for (const auto& [strength, keypoint] : ranked) sorted.push_back(keypoint);
  return sorted;
}

bool IsAbove(const cv::KeyPoint& a, const cv::KeyPoint& b) {
  return std::make_tuple(a.pt.y, a.pt.x, a.size, a.angle) <
         std::make_tuple(b.pt.y, b.pt.x, b.size, b.angle);
}

bool IsInside(const cv::KeyPoint& keypoint, const cv::Size& size, int border_px) {
  const auto border = static_cast<float>(border_px);
  return keypoint.pt.x >= border && keypoint.pt.y >= border &&
         keypoint.pt.x <= static_cast<float>(size.width - 1) - border &&
         keypoint.pt.y <= static_cast<float>(size.height - 1) - border;
}

// The keypoints already accepted, in buckets of the least distance.
class Occupancy {
 public:
  Occupancy(const cv::Size& image_size, double min_distance_px)
      : bucket_px_(std::max(min_distance_px, 1.0)),
        min_squared_(min_distance_px * min_distance_px),
        columns_(static_cast<int>(image_size.width / bucket_px_) + 3),
        rows_(static_cast<int>(image_size.height / bucket_px_) + 3),
        buckets_(static_cast<size_t>(columns_) * static_cast<size_t>(rows_)) {}

  // Accepts the point unless a nearer one was accepted before.
  bool TryInsert(const cv::Point2f& point) {
    const int column = static_cast<int>(point.x / bucket_px_) + 1;
    const int row = static_cast<int>(point.y / bucket_px_) + 1;
    for (int y = row - 1; y <= row + 1; ++y) {
      for (int x = column - 1; x <= column + 1; ++x) {
        if (HasNear(At(x, y), point)) return false;
      }
    }
    At(column, row).push_back(point);
    return true;
  }

 private:
  std::vector<cv::Point2f>& At(int column, int row) {
    return buckets_[static_cast<size_t>(row) * static_cast<size_t>(columns_) +
                    static_cast<size_t>(column)];
  }

  bool HasNear(const std::vector<cv::Point2f>& bucket, const cv::Point2f& point) const {
    return std::any_of(bucket.begin(), bucket.end(), [&](const cv::Point2f& other) {
      const cv::Point2f d = other - point;
      return d.x * d.x + d.y * d.y < min_squared_;
    });
  }

  double bucket_px_;
  double min_squared_;
  int columns_;
  int rows_;
  std::vector<std::vector<cv::Point2f>> buckets_;
};

std::vector<cv::KeyPoint> SuppressNear(const std::vector<cv::KeyPoint>& strongest_first,
                                       const cv::Size& image_size, const SelectOptions& options) {
  Occupancy occupancy(image_size, options.min_distance_px);
  std::vector<cv::KeyPoint> kept;
  for (const cv::KeyPoint& keypoint : strongest_first) {
    if (!IsInside(keypoint, image_size, options.border_px)) continue;
    if (kept.size() == static_cast<size_t>(options.max_candidates)) break;
    if (occupancy.TryInsert(keypoint.pt)) kept.push_back(keypoint);
  }
  return kept;
}

// Orders by rank within the cell, then by strength.
void OrderByCellRank(int cell_px, std::vector<cv::KeyPoint>* strongest_first) {
  std::map<std::pair<int, int>, int> used_of_cell;
  std::vector<std::pair<int, cv::KeyPoint>> ranked;
  for (const cv::KeyPoint& keypoint : *strongest_first) {
    const std::pair cell(static_cast<int>(keypoint.pt.x) / cell_px,
                         static_cast<int>(keypoint.pt.y) / cell_px);
    ranked.emplace_back(used_of_cell[cell]++, keypoint);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (size_t i = 0; i < ranked.size(); ++i) (*strongest_first)[i] = ranked[i].second;
}

}  // namespace

std::vector<cv::KeyPoint> SelectKeypoints(const std::vector<cv::KeyPoint>& candidates,
                                          const cv::Size& image_size,
                                          const SelectOptions& options) {
  std::vector<cv::KeyPoint> chosen =
      SuppressNear(StrongestFirst(candidates, options.size_exponent), image_size, options);
  OrderByCellRank(options.cell_px, &chosen);
  if (chosen.size() > static_cast<size_t>(options.max_keypoints)) {
    chosen.resize(static_cast<size_t>(options.max_keypoints));
  }
  std::sort(chosen.begin(), chosen.end(), IsAbove);
  return chosen;
}

void FillWith(const std::vector<cv::KeyPoint>& more, const cv::Size& image_size,
              const SelectOptions& options, std::vector<cv::KeyPoint>* keypoints) {
  Occupancy occupancy(image_size, options.min_distance_px);
  for (const cv::KeyPoint& keypoint : *keypoints) occupancy.TryInsert(keypoint.pt);
  for (const cv::KeyPoint& keypoint : more) {
    if (keypoints->size() >= static_cast<size_t>(options.max_keypoints)) return;
    if (!IsInside(keypoint, image_size, options.border_px)) continue;
    if (occupancy.TryInsert(keypoint.pt)) keypoints->push_back(keypoint);
  }
}

}  // namespace rovio_sfm
