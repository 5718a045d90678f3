#include "rovio_sfm/sim/world/draw_texture.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "rovio_sfm/sim/world/draw_marks.h"
#include "rovio_sfm/sim/world/noise_field.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm::sim {
namespace {

// Between the two colours by the field; the mean of the field falls half-way.
cv::Mat MixColors(const TextureSpec& spec, const cv::Mat& field) {
  std::vector<cv::Mat> channels(3);
  for (int c = 0; c < 3; ++c) {
    const double mean = 0.5 * (spec.color[c] + spec.accent[c]);
    const double range = 0.5 * spec.contrast * (spec.color[c] - spec.accent[c]);
    field.convertTo(channels[static_cast<size_t>(c)], CV_8U, range, mean);
  }
  cv::Mat image;
  cv::merge(channels, image);
  return image;
}

// Covers the given share with patches of the accent, bounded by level lines of a 1/f field.
void PaintPatches(const TextureSpec& spec, Rng& rng, cv::Mat* image) {
  NoiseFieldOptions options;
  options.coarsest_px = 120.0;
  options.finest_px = 4.0;
  options.octave_gain = 0.75;
  const cv::Mat field = MakeNoiseField(image->size(), options, rng);
  cv::Mat sorted = field.reshape(1, 1).clone();
  float* begin = sorted.ptr<float>();
  float* cut = begin + static_cast<int64_t>((1.0 - spec.patches) * (sorted.cols - 1));
  std::nth_element(begin, cut, begin + sorted.cols);
  cv::Mat mask;
  cv::GaussianBlur(field > *cut, mask, cv::Size(3, 3), 0.7);
  for (int row = 0; row < image->rows; ++row) {
    for (int col = 0; col < image->cols; ++col) {
      const double share = mask.at<uint8_t>(row, col) / 255.0 * 0.8;
      cv::Vec3b& pixel = image->at<cv::Vec3b>(row, col);
      for (int c = 0; c < 3; ++c) {
        pixel[c] = cv::saturate_cast<uint8_t>((1 - share) * pixel[c] + share * spec.accent[c]);
      }
    }
  }
}

// Faint wear over everything, so that no drawn mark is of one flat colour.
void Weather(const cv::Mat& field, cv::Mat* image) {
  constexpr double kStrength = 0.03;
  cv::Mat gain;
  cv::merge(std::vector<cv::Mat>(3, 1.0 + kStrength * field), gain);
  cv::multiply(*image, gain, *image, 1.0, CV_8UC3);
}

}  // namespace

cv::Mat DrawTexture(const TextureSpec& spec) {
  Rng rng(spec.seed);
  NoiseFieldOptions ground;
  ground.stretch = spec.stretch;
  ground.octave_gain = 0.95;
  const cv::Mat field = MakeNoiseField(cv::Size(spec.width_px, spec.height_px), ground, rng);
  cv::Mat image = MixColors(spec, field);
  if (spec.patches > 0.0) PaintPatches(spec, rng, &image);
  for (const std::string& mark : spec.marks) DrawMarks(mark, spec, rng, &image);
  if (!spec.marks.empty()) {
    cv::Mat mirrored;  // spares a second field; nobody sees that the wear mirrors the ground
    cv::flip(field, mirrored, -1);
    Weather(mirrored, &image);
  }
  return image;
}

}  // namespace rovio_sfm::sim
