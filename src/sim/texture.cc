#include "rovio_sfm/sim/texture.h"

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

const std::array<float, 256>& LinearFromSrgb() {
  static const std::array<float, 256> table = MakeLinearFromSrgb();
  return table;
}

Eigen::Vector3f Texel(const cv::Mat& level, int x, int y) {
  const std::array<float, 256>& linear = LinearFromSrgb();
  const uint8_t* p = level.ptr<uint8_t>(y) + 3 * x;
  return {linear[p[0]], linear[p[1]], linear[p[2]]};
}

Eigen::Vector3f Bilinear(const cv::Mat& level, float x, float y) {
  x = std::clamp(x - 0.5f, 0.0f, static_cast<float>(level.cols - 1));
  y = std::clamp(y - 0.5f, 0.0f, static_cast<float>(level.rows - 1));
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, level.cols - 1), y1 = std::min(y0 + 1, level.rows - 1);
  const float a = x - static_cast<float>(x0), b = y - static_cast<float>(y0);
  return (1 - b) * ((1 - a) * Texel(level, x0, y0) + a * Texel(level, x1, y0)) +
         b * ((1 - a) * Texel(level, x0, y1) + a * Texel(level, x1, y1));
}

}  // namespace

Texture::Texture(const cv::Mat& rgb, double texel_m) : texel_m_(texel_m) {
  ROVIO_CHECK(rgb.type() == CV_8UC3 && !rgb.empty() && texel_m > 0.0);
  levels_.push_back(rgb);
  while (std::min(levels_.back().cols, levels_.back().rows) >= 2 * kMinLevelSize) {
    cv::Mat half;
    cv::resize(levels_.back(), half, cv::Size(levels_.back().cols / 2, levels_.back().rows / 2), 0,
               0, cv::INTER_AREA);
    levels_.push_back(half);
  }
}

Eigen::Vector3f Texture::Sample(float x, float y, float footprint_texels) const {
  const float max_level = static_cast<float>(levels_.size() - 1);
  const float level = std::clamp(std::log2(std::max(footprint_texels, 1e-6f)), 0.0f, max_level);
  const size_t below = static_cast<size_t>(level);
  const float share = level - static_cast<float>(below);
  const float scale = 1.0f / static_cast<float>(1u << below);
  const Eigen::Vector3f fine = Bilinear(levels_[below], x * scale, y * scale);
  if (share < 0.02f || below + 1 >= levels_.size()) return fine;
  const Eigen::Vector3f coarse = Bilinear(levels_[below + 1], 0.5f * x * scale, 0.5f * y * scale);
  return (1 - share) * fine + share * coarse;
}

}  // namespace rovio_sfm::sim
