#include "rovio_sfm/sim/noise_field.h"

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

}  // namespace

cv::Mat MakeNoiseField(const cv::Size& size_px, const NoiseFieldOptions& options, Rng& rng) {
  cv::Mat sum(size_px, CV_32F, cv::Scalar(0));
  double variance = 0.0;
  double amplitude = 1.0;
  constexpr double kOctaveVariance = 0.2;  // of cubic interpolation of uniform numbers in [-1, 1]
  for (double cell_px = options.coarsest_px; cell_px >= options.finest_px; cell_px *= 0.5) {
    sum += amplitude * Octave(size_px, cell_px * options.stretch, cell_px, rng);
    variance += kOctaveVariance * amplitude * amplitude;
    amplitude *= options.octave_gain;
  }
  if (variance > 0.0) sum /= std::sqrt(variance);
  return sum;
}

}  // namespace rovio_sfm::sim
