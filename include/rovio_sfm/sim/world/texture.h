#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

namespace rovio_sfm::sim {

// The paint of surfaces: an image (8-bit RGB, sRGB) with its mip levels. Immutable, so that any
// thread may sample it.
class Texture {
 public:
  // rgb: CV_8UC3 in the order red, green, blue; texel_m: the side of a texel on a surface.
  Texture(const cv::Mat& rgb, double texel_m);

  // Linear RGB at a position in texels of level 0 (0.5 is the centre of the first), smoothed over
  // footprint_texels; bilinear, clamped at the border. Between two levels the chance in [0, 1)
  // decides: the mean over many samples is the blend.
  Eigen::Vector3f Sample(float x, float y, float footprint_texels, float chance) const;

  double texel_m() const { return texel_m_; }
  cv::Size size_px() const { return levels_.front().size(); }
  const cv::Mat& rgb() const { return levels_.front(); }

 private:
  std::vector<cv::Mat> levels_;
  double texel_m_;
};

}  // namespace rovio_sfm::sim
