#include "rovio_sfm/features/sift_keypoints.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace rovio_sfm {
namespace {

constexpr int kNumDifferences = kSiftLayers + 2;
constexpr int kMaxSteps = 5;        // of a refinement, from pixel to pixel
constexpr float kMaxOffset = 1e6f;  // pixels; beyond there is no extremum
constexpr float kFullContrast = 255.0f;
constexpr double kCornerQuality = 1e-3;  // least, of the strongest corner's
constexpr int kCornerWindow = 7;         // side, pixels of its octave

using Row = Eigen::ArrayXf;

Eigen::Map<const Row> RowOf(const cv::Mat& image, int y) {
  return {image.ptr<float>(y), image.cols};
}

// Of one difference: its last three rows, and the greatest and least of each column of them.
class DifferenceRows {
 public:
  void Add(const SiftOctave& octave, int layer, int y) {
    const auto at = static_cast<size_t>(layer);
    rows_[static_cast<size_t>(y % 3)] =
        RowOf(octave.images[at + 1], y) - RowOf(octave.images[at], y);
  }

  void Compare() {
    greatest_ = rows_[0].max(rows_[1]).max(rows_[2]);
    least_ = rows_[0].min(rows_[1]).min(rows_[2]);
  }

  const Row& row(int y) const { return rows_[static_cast<size_t>(y % 3)]; }
  const Row& greatest() const { return greatest_; }
  const Row& least() const { return least_; }

 private:
  std::array<Row, 3> rows_;
  Row greatest_, least_;
};

struct GridPoint {
  int layer = 0, y = 0, x = 0;
};

// Finds the extrema of one octave's differences, row by row: they are never held as images.
class ExtremumFinder {
 public:
  ExtremumFinder(const SiftOctave& octave, float threshold)
      : octave_(octave), threshold_(threshold) {}

  std::vector<GridPoint> Find() {
    const int end = octave_.images[0].rows - kSiftBorder;
    AddRow(kSiftBorder - 1);
    AddRow(kSiftBorder);
    for (int y = kSiftBorder; y < end; ++y) {
      AddRow(y + 1);
      for (DifferenceRows& rows : differences_) rows.Compare();
      for (int layer = 1; layer <= kSiftLayers; ++layer) FindInRow(layer, y);
    }
    return std::move(found_);
  }

 private:
  void AddRow(int y) {
    for (int layer = 0; layer < kNumDifferences; ++layer) {
      differences_[static_cast<size_t>(layer)].Add(octave_, layer, y);
    }
  }

  void FindInRow(int layer, int y) {
    const auto at = static_cast<size_t>(layer);
    const DifferenceRows &below = differences_[at - 1], &own = differences_[at],
                         &above = differences_[at + 1];
    column_greatest_ = below.greatest().max(own.greatest()).max(above.greatest());
    column_least_ = below.least().min(own.least()).min(above.least());
    const Eigen::Index width = column_greatest_.size() - 2;  // without the first and the last
    greatest_ = column_greatest_.head(width)
                    .max(column_greatest_.segment(1, width))
                    .max(column_greatest_.tail(width));
    least_ = column_least_.head(width)
                 .min(column_least_.segment(1, width))
                 .min(column_least_.tail(width));
    const Row& row = own.row(y);
    // At most 0 where it is both as strong as the threshold and the greatest or the least.
    lack_ = (greatest_ - row.segment(1, width))
                .min(row.segment(1, width) - least_)
                .max(threshold_ - row.segment(1, width).abs());
    const float* lack = lack_.data();  // from the second column on
    for (Eigen::Index x = kSiftBorder; x < row.size() - kSiftBorder; ++x) {
      if (lack[x - 1] > 0.0f) continue;
      const float value = row[x];
      if (std::abs(value) > threshold_ &&
          value == (value > 0.0f ? greatest_[x - 1] : least_[x - 1])) {
        found_.push_back({layer, y, static_cast<int>(x)});
      }
    }
  }

  const SiftOctave& octave_;
  float threshold_;
  std::array<DifferenceRows, kNumDifferences> differences_;
  Row column_greatest_, column_least_, greatest_, least_, lack_;
  std::vector<GridPoint> found_;
};

// Value, slope and curvature of the differences, axes x, y, layer, in full contrasts.
struct Quadric {
  float value = 0.0f;
  Eigen::Vector3f gradient;
  Eigen::Matrix3f hessian;
};

// The differences around the point, x fastest, then y, then layer.
std::array<float, 27> DifferencesAround(const SiftOctave& octave, const GridPoint& p) {
  std::array<float, 27> differences;
  size_t i = 0;
  for (int layer = p.layer - 1; layer <= p.layer + 1; ++layer) {
    const cv::Mat &above = octave.images[static_cast<size_t>(layer + 1)],
                  &below = octave.images[static_cast<size_t>(layer)];
    for (int y = p.y - 1; y <= p.y + 1; ++y) {
      const float *row_above = above.ptr<float>(y), *row_below = below.ptr<float>(y);
      for (int x = p.x - 1; x <= p.x + 1; ++x) {
        differences[i++] = (row_above[x] - row_below[x]) / kFullContrast;
      }
    }
  }
  return differences;
}

Quadric QuadricAt(const SiftOctave& octave, const GridPoint& p) {
  constexpr std::array<int, 3> kStride = {1, 3, 9};
  const std::array<float, 27> differences = DifferencesAround(octave, p);
  const float* middle = &differences[13];
  Quadric quadric;
  quadric.value = *middle;
  for (int i = 0; i < 3; ++i) {
    const int step = kStride[static_cast<size_t>(i)];
    quadric.gradient[i] = 0.5f * (middle[step] - middle[-step]);
    quadric.hessian(i, i) = middle[step] + middle[-step] - 2.0f * *middle;
    for (int j = 0; j < i; ++j) {
      const int other = kStride[static_cast<size_t>(j)];
      quadric.hessian(i, j) = quadric.hessian(j, i) =
          0.25f * (middle[step + other] - middle[step - other] - middle[other - step] +
                   middle[-step - other]);
    }
  }
  return quadric;
}

bool IsInside(const GridPoint& p, const cv::Mat& image) {
  return p.layer >= 1 && p.layer <= kSiftLayers && p.x >= kSiftBorder && p.y >= kSiftBorder &&
         p.x < image.cols - kSiftBorder && p.y < image.rows - kSiftBorder;
}

bool IsOnEdge(const Quadric& quadric, double max_ratio) {
  const double trace = quadric.hessian(0, 0) + quadric.hessian(1, 1);
  const double determinant = quadric.hessian.topLeftCorner<2, 2>().determinant();
  return determinant <= 0.0 ||
         trace * trace * max_ratio >= (max_ratio + 1.0) * (max_ratio + 1.0) * determinant;
}

cv::KeyPoint KeypointAt(const SiftOctave& octave, const GridPoint& p, const Eigen::Vector3f& offset,
                        float response) {
  const float scale = static_cast<float>(kSiftSigma) *
                      std::exp2((static_cast<float>(p.layer) + offset.z()) / kSiftLayers);
  cv::KeyPoint keypoint;
  keypoint.pt.x = (static_cast<float>(p.x) + offset.x()) * octave.pixel_px + octave.origin_px;
  keypoint.pt.y = (static_cast<float>(p.y) + offset.y()) * octave.pixel_px + octave.origin_px;
  keypoint.size = 2.0f * scale * octave.pixel_px;
  keypoint.response = response;
  keypoint.class_id = p.layer;
  return keypoint;
}

std::optional<cv::KeyPoint> Refine(const SiftOctave& octave, GridPoint p,
                                   const SiftKeypointOptions& options) {
  for (int step = 0; step < kMaxSteps; ++step) {
    const Quadric quadric = QuadricAt(octave, p);
    const Eigen::Vector3f offset = quadric.hessian.partialPivLu().solve(-quadric.gradient);
    if (!offset.allFinite() || offset.cwiseAbs().maxCoeff() > kMaxOffset) return std::nullopt;
    if (offset.cwiseAbs().maxCoeff() < 0.5f) {
      const float contrast = std::abs(quadric.value + 0.5f * quadric.gradient.dot(offset));
      if (contrast * kSiftLayers < static_cast<float>(options.contrast)) return std::nullopt;
      if (IsOnEdge(quadric, options.edge)) return std::nullopt;
      return KeypointAt(octave, p, offset, contrast);
    }
    p.x += static_cast<int>(std::lround(offset.x()));
    p.y += static_cast<int>(std::lround(offset.y()));
    p.layer += static_cast<int>(std::lround(offset.z()));
    if (!IsInside(p, octave.images[0])) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::vector<cv::KeyPoint> FindSiftKeypoints(const std::vector<SiftOctave>& octaves,
                                            const SiftKeypointOptions& options) {
  const float threshold = 0.5f * static_cast<float>(options.contrast) / kSiftLayers * kFullContrast;
  std::vector<cv::KeyPoint> keypoints;
  for (size_t i = 0; i < octaves.size(); ++i) {
    for (const GridPoint& p : ExtremumFinder(octaves[i], threshold).Find()) {
      std::optional<cv::KeyPoint> keypoint = Refine(octaves[i], p, options);
      if (!keypoint) continue;
      keypoint->octave = static_cast<int>(i);
      keypoints.push_back(*keypoint);
    }
  }
  return keypoints;
}

std::vector<cv::KeyPoint> FindCorners(const SiftOctave& finest, double min_distance_px) {
  constexpr int kLayer = 1;
  const cv::Mat& image = finest.images[kLayer];
  std::vector<cv::Point2f> corners;
  cv::goodFeaturesToTrack(image, corners, 0, kCornerQuality,
                          min_distance_px / double{finest.pixel_px}, {}, kCornerWindow);
  if (corners.empty()) return {};
  const cv::Size half_window(kCornerWindow / 2, kCornerWindow / 2);
  cv::cornerSubPix(image, corners, half_window, {-1, -1},
                   {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 20, 0.01});
  std::vector<cv::KeyPoint> keypoints;
  for (const cv::Point2f& corner : corners) {
    keypoints.push_back(KeypointAt(finest, {kLayer, 0, 0}, {corner.x, corner.y, 0.0f}, 0.0f));
  }
  return keypoints;
}

}  // namespace rovio_sfm
