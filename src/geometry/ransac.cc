#include "rovio_sfm/geometry/ransac.h"

#include <limits>

namespace rovio_sfm {

double NumSamplesNeeded(double inlier_share, int sample_size, double confidence) {
  const double all_inliers = std::pow(inlier_share, sample_size);
  if (!(all_inliers > 0.0)) return std::numeric_limits<double>::infinity();
  if (all_inliers >= 1.0) return 1.0;
  return std::ceil(std::log1p(-confidence) / std::log1p(-all_inliers));
}

void DrawSample(uint32_t count, Rng& rng, std::vector<uint32_t>* sample) {
  for (auto it = sample->begin(); it != sample->end(); ++it) {
    do {
      *it = rng.UniformInt(count);
    } while (std::find(sample->begin(), it, *it) != it);
  }
}

uint32_t ProsacPoolSize(uint32_t num_data, int sample_size, int iteration, int prosac_samples) {
  const uint32_t least = std::min(num_data, static_cast<uint32_t>(4 * sample_size));
  if (iteration >= prosac_samples) return num_data;
  const double share = static_cast<double>(iteration) / prosac_samples;
  return least + static_cast<uint32_t>(share * (num_data - least));
}

bool HasDrawnEnough(int num_samples, const std::vector<uint32_t>& inliers, uint32_t pool_size,
                    int sample_size, const RansacOptions& options) {
  if (num_samples < options.min_iterations) return false;
  const auto in_pool = std::lower_bound(inliers.begin(), inliers.end(), pool_size);
  const double share = static_cast<double>(in_pool - inliers.begin()) / pool_size;
  return num_samples >= NumSamplesNeeded(share, sample_size, options.confidence);
}

}  // namespace rovio_sfm
