#include "rovio_sfm/sim/world/noise_field.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace rovio_sfm::sim {
namespace {

cv::Mat RandomGrid(const cv::Size& size, Rng& rng) {
  cv::Mat grid(size, CV_32F);
  for (int row = 0; row < size.height; ++row) {
    for (int col = 0; col < size.width; ++col) {
      grid.at<float>(row, col) = static_cast<float>(rng.Uniform(-1.0, 1.0));
    }
  }
  return grid;
}

// Smooth noise with cells of the given size, shifted by a random part of a cell.
cv::Mat Octave(const cv::Size& size_px, double cell_x_px, double cell_y_px, Rng& rng) {
  const cv::Size cells(static_cast<int>(std::ceil(size_px.width / cell_x_px)) + 3,
                       static_cast<int>(std::ceil(size_px.height / cell_y_px)) + 3);
  const cv::Mat grid = RandomGrid(cells, rng);
  const cv::Matx23d grid_from_field(1.0 / cell_x_px, 0.0, 1.0 + rng.Uniform(),  //
                                    0.0, 1.0 / cell_y_px, 1.0 + rng.Uniform());
  cv::Mat field;
  cv::warpAffine(grid, field, grid_from_field, size_px, cv::INTER_CUBIC | cv::WARP_INVERSE_MAP,
                 cv::BORDER_REFLECT);
  return field;
}

// Coarse octaves are drawn on a small picture, which is then enlarged.
cv::Size SizeForCell(const cv::Size& size_px, double cell_px) {
  constexpr double kEnoughPerCell = 6.0;
  const double scale = std::min(1.0, kEnoughPerCell / cell_px);
  return {static_cast<int>(std::ceil(size_px.width * scale)),
          static_cast<int>(std::ceil(size_px.height * scale))};
}

}  // namespace

cv::Mat MakeNoiseField(const cv::Size& size_px, const NoiseFieldOptions& options, Rng& rng) {
  cv::Mat sum;
  double variance = 0.0;
  double amplitude = 1.0;
  constexpr double kOctaveVariance = 0.2;  // of cubic interpolation of uniform numbers in [-1, 1]
  for (double cell_px = options.coarsest_px; cell_px >= options.finest_px; cell_px *= 0.5) {
    const cv::Size size = SizeForCell(size_px, cell_px);
    const double scale = static_cast<double>(size.width) / size_px.width;
    cv::Mat octave =
        amplitude * Octave(size, scale * cell_px * options.stretch, scale * cell_px, rng);
    if (sum.empty()) {
      sum = octave;
    } else {
      cv::resize(sum, sum, size, 0, 0, cv::INTER_LINEAR);
      sum += octave;
    }
    variance += kOctaveVariance * amplitude * amplitude;
    amplitude *= options.octave_gain;
  }
  if (sum.empty()) return cv::Mat(size_px, CV_32F, cv::Scalar(0));
  cv::resize(sum, sum, size_px, 0, 0, cv::INTER_LINEAR);
  return sum / std::sqrt(variance);
}

}  // namespace rovio_sfm::sim
