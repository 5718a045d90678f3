#include "rovio_sfm/features/sift_descriptors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core/hal/hal.hpp>

#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm {
namespace {

constexpr int kNumDirections = 36;        // of the histogram that gives the angle
constexpr float kDirectionSigmas = 1.5f;  // its window, in scales of the keypoint
constexpr int kCells = 4, kBins = 8;      // the descriptor: cells a side, directions a cell
constexpr float kCellScales = 3.0f;       // side of a cell, in scales of the keypoint
constexpr float kClip = 0.2f;             // greatest part of the whole
constexpr float kDescriptorNorm = 512.0f;

// A keypoint in its octave's pixels.
struct Spot {
  const cv::Mat& image;
  float scale;
  int x, y;
};

Spot SpotOf(const std::vector<SiftOctave>& octaves, const cv::KeyPoint& keypoint) {
  const SiftOctave& octave = octaves[static_cast<size_t>(keypoint.octave)];
  const auto pixel = [&](float x_px) {
    return static_cast<int>(std::lround((x_px - octave.origin_px) / octave.pixel_px));
  };
  return {octave.images[static_cast<size_t>(keypoint.class_id)],
          0.5f * keypoint.size / octave.pixel_px, pixel(keypoint.pt.x), pixel(keypoint.pt.y)};
}

// A Gauss bell by distance from its middle.
std::vector<float> HalfBell(int radius, float sigma) {
  std::vector<float> bell;
  for (int i = 0; i <= radius; ++i) {
    bell.push_back(std::exp(-0.5f * static_cast<float>(i * i) / (sigma * sigma)));
  }
  return bell;
}

// The gradients of some pixels: angle in degrees, length times a weight; where they are, in cells.
class Gradients {
 public:
  // Forgets all; so many may be added.
  void Reset(size_t max_count) {
    count_ = 0;
    if (dx_.size() >= max_count) return;
    for (auto* values : {&dx_, &dy_, &weight_, &row_, &column_, &angle_, &length_}) {
      values->resize(max_count);
    }
  }

  void Add(const cv::Mat& image, int y, int x, float weight, float row, float column) {
    const float* at = image.ptr<float>(y) + x;
    dx_[count_] = at[1] - at[-1];
    dy_[count_] = image.ptr<float>(y + 1)[x] - image.ptr<float>(y - 1)[x];
    weight_[count_] = weight;
    row_[count_] = row;
    column_[count_] = column;
    ++count_;
  }

  void Finish() {
    const int count = static_cast<int>(count_);
    cv::hal::fastAtan32f(dy_.data(), dx_.data(), angle_.data(), count, true);
    cv::hal::magnitude32f(dx_.data(), dy_.data(), length_.data(), count);
    for (size_t i = 0; i < count_; ++i) length_[i] *= weight_[i];
  }

  size_t Count() const { return count_; }
  float angle(size_t i) const { return angle_[i]; }
  float length(size_t i) const { return length_[i]; }
  float row(size_t i) const { return row_[i]; }
  float column(size_t i) const { return column_[i]; }

 private:
  size_t count_ = 0;
  std::vector<float> dx_, dy_, weight_, row_, column_, angle_, length_;
};

// Of a square window.
size_t NumPixels(int radius) {
  const auto side = static_cast<size_t>(2 * radius + 1);
  return side * side;
}

using Directions = std::array<float, kNumDirections>;

Directions DirectionsAround(const Spot& spot, Gradients* gradients) {
  const float sigma = kDirectionSigmas * spot.scale;
  const int radius = static_cast<int>(std::lround(3.0f * sigma));
  const std::vector<float> bell = HalfBell(radius, sigma);
  const auto at = [&](int i) { return bell[static_cast<size_t>(std::abs(i))]; };
  gradients->Reset(NumPixels(radius));
  for (int y = std::max(1, spot.y - radius); y <= std::min(spot.image.rows - 2, spot.y + radius);
       ++y) {
    for (int x = std::max(1, spot.x - radius); x <= std::min(spot.image.cols - 2, spot.x + radius);
         ++x) {
      gradients->Add(spot.image, y, x, at(y - spot.y) * at(x - spot.x), 0.0f, 0.0f);
    }
  }
  gradients->Finish();
  Directions directions{};
  for (size_t i = 0; i < gradients->Count(); ++i) {
    const auto bin = static_cast<size_t>(gradients->angle(i) * (kNumDirections / 360.0f) + 0.5f);
    directions[bin % kNumDirections] += gradients->length(i);
  }
  return directions;
}

float StrongestDirection(const Directions& raw) {
  const auto at = [](const Directions& directions, int i) {
    return directions[static_cast<size_t>((i + kNumDirections) % kNumDirections)];
  };
  Directions smooth;
  for (int i = 0; i < kNumDirections; ++i) {
    smooth[static_cast<size_t>(i)] = (at(raw, i - 2) + at(raw, i + 2)) / 16.0f +
                                     (at(raw, i - 1) + at(raw, i + 1)) / 4.0f + at(raw, i) * 0.375f;
  }
  const int best =
      static_cast<int>(std::max_element(smooth.begin(), smooth.end()) - smooth.begin());
  const float before = at(smooth, best - 1), peak = at(smooth, best), after = at(smooth, best + 1);
  const float curvature = before - 2.0f * peak + after;
  const float offset = curvature < 0.0f ? 0.5f * (before - after) / curvature : 0.0f;
  const float angle = (static_cast<float>(best) + offset) * (360.0f / kNumDirections);
  return angle < 0.0f ? angle + 360.0f : angle;
}

// The whole numbers x with |x slope + offset| <= reach, cut from [*first, *last].
void CutToBand(float slope, float offset, float reach, int* first, int* last) {
  if (std::abs(slope) < 1e-6f) {
    if (std::abs(offset) > reach) *last = *first - 1;
    return;
  }
  const float a = (-reach - offset) / slope, b = (reach - offset) / slope;
  *first = std::max(*first, static_cast<int>(std::ceil(std::min(a, b))));
  *last = std::min(*last, static_cast<int>(std::floor(std::max(a, b))));
}

// Gradients of the turned square of cells around the spot, half a cell wider on each side.
void GatherCells(const Spot& spot, float angle_deg, Gradients* gradients) {
  const float cell_px = kCellScales * spot.scale, reach = 0.5f * (kCells + 1) * cell_px;
  const auto angle_rad = static_cast<float>(Radians(angle_deg));
  const float cosine = std::cos(angle_rad), sine = std::sin(angle_rad);
  const int radius = static_cast<int>(std::lround(std::sqrt(2.0f) * reach));
  const std::vector<float> bell = HalfBell(radius, 0.5f * kCells * cell_px);
  const auto at = [&](int i) { return bell[static_cast<size_t>(std::abs(i))]; };
  gradients->Reset(NumPixels(radius));
  for (int i = std::max(-radius, 1 - spot.y); i <= std::min(radius, spot.image.rows - 2 - spot.y);
       ++i) {
    const auto down = static_cast<float>(i);
    int first = std::max(-radius, 1 - spot.x);
    int last = std::min(radius, spot.image.cols - 2 - spot.x);
    CutToBand(cosine, down * sine, reach, &first, &last);
    CutToBand(-sine, down * cosine, reach, &first, &last);
    for (int j = first; j <= last; ++j) {
      const auto right = static_cast<float>(j);
      const float row = (down * cosine - right * sine) / cell_px + 0.5f * (kCells - 1);
      const float column = (right * cosine + down * sine) / cell_px + 0.5f * (kCells - 1);
      gradients->Add(spot.image, spot.y + i, spot.x + j, at(i) * at(j), row, column);
    }
  }
  gradients->Finish();
}

// Cells with a rim of one, so that shares beyond the square need no question.
using Histogram = std::array<std::array<std::array<float, kBins + 1>, kCells + 2>, kCells + 2>;

// Shares each gradient among the two nearest rows, columns and directions.
Histogram ShareOut(const Gradients& gradients, float angle_deg) {
  Histogram histogram{};
  for (size_t i = 0; i < gradients.Count(); ++i) {
    float bin = (angle_deg - gradients.angle(i)) * (kBins / 360.0f);
    if (bin < 0.0f) bin += kBins;
    const float row = std::clamp(gradients.row(i) + 1.0f, 0.0f, kCells + 0.999f);
    const float column = std::clamp(gradients.column(i) + 1.0f, 0.0f, kCells + 0.999f);
    const auto r = static_cast<size_t>(row), c = static_cast<size_t>(column);
    const auto b = std::min(static_cast<size_t>(bin), size_t{kBins - 1});
    const float in_row = row - static_cast<float>(r), in_column = column - static_cast<float>(c);
    const float in_bin = bin - static_cast<float>(b);
    const float lower = gradients.length(i) * in_row, upper = gradients.length(i) - lower;
    const auto share = [&](std::array<float, kBins + 1>* cell, float length) {
      (*cell)[b + 1] += length * in_bin;
      (*cell)[b] += length - length * in_bin;
    };
    share(&histogram[r][c + 1], upper * in_column);
    share(&histogram[r][c], upper - upper * in_column);
    share(&histogram[r + 1][c + 1], lower * in_column);
    share(&histogram[r + 1][c], lower - lower * in_column);
  }
  return histogram;
}

void Normalize(float* descriptor) {
  constexpr int kLength = kCells * kCells * kBins;
  cv::Mat row(1, kLength, CV_32F, descriptor);
  const double clip = kClip * cv::norm(row);
  cv::min(row, clip, row);
  const auto factor = kDescriptorNorm / std::max(static_cast<float>(cv::norm(row)), 1e-7f);
  for (int i = 0; i < kLength; ++i) {
    descriptor[i] = std::min(255.0f, std::nearbyint(descriptor[i] * factor));
  }
}

}  // namespace

void OrientSift(const std::vector<SiftOctave>& octaves, std::vector<cv::KeyPoint>* keypoints) {
  Gradients gradients;
  for (cv::KeyPoint& keypoint : *keypoints) {
    keypoint.angle = StrongestDirection(DirectionsAround(SpotOf(octaves, keypoint), &gradients));
  }
}

cv::Mat DescribeSift(const std::vector<SiftOctave>& octaves,
                     const std::vector<cv::KeyPoint>& keypoints) {
  cv::Mat descriptors(static_cast<int>(keypoints.size()), kCells * kCells * kBins, CV_32F);
  Gradients gradients;
  for (size_t i = 0; i < keypoints.size(); ++i) {
    GatherCells(SpotOf(octaves, keypoints[i]), keypoints[i].angle, &gradients);
    const Histogram histogram = ShareOut(gradients, keypoints[i].angle);
    float* out = descriptors.ptr<float>(static_cast<int>(i));
    for (size_t row = 1; row <= kCells; ++row) {
      for (size_t column = 1; column <= kCells; ++column, out += kBins) {
        const auto& cell = histogram[row][column];
        std::copy_n(cell.begin(), kBins, out);
        out[0] += cell[kBins];
      }
    }
    Normalize(descriptors.ptr<float>(static_cast<int>(i)));
  }
  return descriptors;
}

}  // namespace rovio_sfm
