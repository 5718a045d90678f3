#include "rovio_sfm/matching/known_matches.h"

namespace rovio_sfm {

std::vector<bool> UsedFeatures(size_t num_features, const std::vector<FeatureMatch>& known,
                               uint32_t FeatureMatch::*side) {
  std::vector<bool> used(num_features, false);
  for (const FeatureMatch& match : known) used[match.*side] = true;
  return used;
}

float MeanDistance(const std::vector<FeatureMatch>& matches) {
  double sum = 0.0;
  for (const FeatureMatch& match : matches) sum += double{match.distance};
  return static_cast<float>(sum / static_cast<double>(matches.size()));
}

}  // namespace rovio_sfm
