#include "rovio_sfm/sim/world/texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm::sim {
namespace {

constexpr int kMinLevelSize = 4;  // px

std::array<float, 256> MakeLinearFromSrgb() {
  std::array<float, 256> table{};
  for (size_t i = 0; i < table.size(); ++i) {
    const double value = static_cast<double>(i) / 255.0;
    table[i] = static_cast<float>(value <= 0.04045 ? value / 12.92
                                                   : std::pow((value + 0.055) / 1.055, 2.4));
  }
  return table;
}

const std::array<float, 256> kLinearFromSrgb = MakeLinearFromSrgb();

Eigen::Vector3f Linear(const uint8_t* rgb) {
  return {kLinearFromSrgb[rgb[0]], kLinearFromSrgb[rgb[1]], kLinearFromSrgb[rgb[2]]};
}

Eigen::Vector3f Bilinear(const cv::Mat& level, float x, float y) {
  x = std::clamp(x - 0.5f, 0.0f, static_cast<float>(level.cols - 1));
  y = std::clamp(y - 0.5f, 0.0f, static_cast<float>(level.rows - 1));
  const int x0 = std::min(static_cast<int>(x), level.cols - 2);
  const int y0 = std::min(static_cast<int>(y), level.rows - 2);
  const float a = x - static_cast<float>(x0), b = y - static_cast<float>(y0);
  const uint8_t* upper = level.ptr<uint8_t>(y0) + 3 * x0;
  const uint8_t* lower = level.ptr<uint8_t>(y0 + 1) + 3 * x0;
  const Eigen::Vector3f above = (1 - a) * Linear(upper) + a * Linear(upper + 3);
  const Eigen::Vector3f below = (1 - a) * Linear(lower) + a * Linear(lower + 3);
  return (1 - b) * above + b * below;
}

}  // namespace

Texture::Texture(const cv::Mat& rgb, double texel_m) : texel_m_(texel_m) {
  ROVIO_CHECK(rgb.type() == CV_8UC3 && rgb.rows >= 2 && rgb.cols >= 2 && texel_m > 0.0);
  levels_.push_back(rgb);
  while (std::min(levels_.back().cols, levels_.back().rows) >= 2 * kMinLevelSize) {
    cv::Mat half;
    cv::resize(levels_.back(), half, cv::Size(levels_.back().cols / 2, levels_.back().rows / 2), 0,
               0, cv::INTER_AREA);
    levels_.push_back(half);
  }
}

Eigen::Vector3f Texture::Sample(float x, float y, float footprint_texels, float chance) const {
  const float max_level = static_cast<float>(levels_.size() - 1);
  const float level = std::clamp(std::log2(std::max(footprint_texels, 1e-6f)), 0.0f, max_level);
  const size_t chosen = static_cast<size_t>(std::min(level + chance, max_level));
  const float scale = 1.0f / static_cast<float>(1u << chosen);
  return Bilinear(levels_[chosen], x * scale, y * scale);
}

}  // namespace rovio_sfm::sim
