#include "rovio_sfm/features/sift_octaves.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

constexpr double kCameraSigmaPx = 0.5;  // blur that a picture has by itself

// The blur that makes `to` of `from`.
double BlurBetween(double from, double to) { return std::sqrt(to * to - from * from); }

cv::Mat Blur(const cv::Mat& image, double sigma) {
  cv::Mat blurred;
  cv::GaussianBlur(image, blurred, cv::Size(), sigma, sigma);
  return blurred;
}

cv::Mat FirstImage(const cv::Mat& grey, bool upsample) {
  cv::Mat image;
  grey.convertTo(image, CV_32F);
  if (!upsample) return Blur(image, BlurBetween(kCameraSigmaPx, kSiftSigma));
  cv::Mat doubled;
  cv::resize(image, doubled, cv::Size(), 2.0, 2.0, cv::INTER_LINEAR);
  return Blur(doubled, BlurBetween(2.0 * kCameraSigmaPx, kSiftSigma));
}

void AddImages(SiftOctave* octave) {
  const double factor = std::exp2(1.0 / kSiftLayers);
  double sigma = kSiftSigma;
  for (int i = 1; i < kSiftLayers + 3; ++i, sigma *= factor) {
    octave->images.push_back(Blur(octave->images.back(), BlurBetween(sigma, sigma * factor)));
  }
}

cv::Mat EverySecond(const cv::Mat& image) {
  cv::Mat half;
  cv::resize(image, half, cv::Size(image.cols / 2, image.rows / 2), 0.0, 0.0, cv::INTER_NEAREST);
  return half;
}

}  // namespace

std::vector<SiftOctave> BuildSiftOctaves(const cv::Mat& grey, bool upsample) {
  ROVIO_CHECK(grey.type() == CV_8U);
  std::vector<SiftOctave> octaves;
  cv::Mat first = FirstImage(grey, upsample);
  float pixel_px = upsample ? 0.5f : 1.0f;
  while (std::min(first.cols, first.rows) > 2 * kSiftBorder) {
    SiftOctave octave{{first}, pixel_px, upsample ? -0.25f : 0.0f};
    AddImages(&octave);
    first = EverySecond(octave.images[kSiftLayers]);
    pixel_px *= 2.0f;
    octaves.push_back(std::move(octave));
  }
  return octaves;
}

}  // namespace rovio_sfm
