#include "rovio_sfm/places/measure_detector.h"

#include <algorithm>

namespace rovio_sfm {

DetectorReport MeasureDetector(const std::vector<BagPair>& pairs, const ChowLiuTree& tree) {
  DetectorReport report;
  double num_again = 0.0, num_by_chance = 0.0;
  for (const BagPair& pair : pairs) {
    report.num_words += pair.first.size();
    for (const uint32_t word : pair.first) {
      num_again += std::binary_search(pair.second.begin(), pair.second.end(), word) ? 1.0 : 0.0;
      num_by_chance += tree[word].p_z;
    }
  }
  if (report.num_words == 0) return report;
  const auto num_words = static_cast<double>(report.num_words);
  report.seen_again = num_again / num_words;
  report.p_z_given_e = std::max(0.0, (num_again - num_by_chance) / (num_words - num_by_chance));
  return report;
}

}  // namespace rovio_sfm
