#include "rovio_sfm/tools/second_look.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm {
namespace {

// Between 1 / greatest and greatest, even in the logarithm.
double RandomFactor(double greatest, Rng* rng) {
  return std::exp(rng->Uniform(-1.0, 1.0) * std::log(greatest));
}

double RandomSigned(double greatest, Rng* rng) { return greatest * rng->Uniform(-1.0, 1.0); }

cv::Matx33d Translation(double x, double y) { return {1, 0, x, 0, 1, y, 0, 0, 1}; }

cv::Matx33d RandomHomography(cv::Size size, const SecondLookOptions& options, Rng* rng) {
  const double roll_rad = RandomSigned(Radians(options.max_roll_deg), rng);
  const double zoom = RandomFactor(options.max_zoom, rng);
  const double cos = zoom * std::cos(roll_rad), sin = zoom * std::sin(roll_rad);
  const double tilt_x = RandomSigned(options.max_perspective, rng) / size.width;
  const double tilt_y = RandomSigned(options.max_perspective, rng) / size.height;
  const double shift_x = RandomSigned(options.max_shift, rng) * size.width;
  const double shift_y = RandomSigned(options.max_shift, rng) * size.height;
  const cv::Matx33d around_center(cos, -sin, 0, sin, cos, 0, tilt_x, tilt_y, 1);
  const double x = 0.5 * size.width, y = 0.5 * size.height;
  return Translation(x + shift_x, y + shift_y) * around_center * Translation(-x, -y);
}

void AddNoise(double sigma, double gain, Rng* rng, cv::Mat* bgr) {
  for (int row = 0; row < bgr->rows; ++row) {
    uint8_t* values = bgr->ptr<uint8_t>(row);
    for (int i = 0; i < 3 * bgr->cols; ++i) {
      values[i] = cv::saturate_cast<uint8_t>(gain * values[i] + sigma * rng->Gaussian());
    }
  }
}

}  // namespace

cv::Mat TakeSecondLook(const cv::Mat& bgr, const SecondLookOptions& options, Rng* rng) {
  cv::Mat look;
  cv::warpPerspective(bgr, look, RandomHomography(bgr.size(), options, rng), bgr.size(),
                      cv::INTER_AREA, cv::BORDER_REPLICATE);
  AddNoise(options.noise_sigma, RandomFactor(options.max_gain, rng), rng, &look);
  return look;
}

}  // namespace rovio_sfm
