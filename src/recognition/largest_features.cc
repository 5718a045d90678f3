#include "rovio_sfm/recognition/largest_features.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace rovio_sfm {
namespace {

std::vector<size_t> LargestIndices(const std::vector<Keypoint>& keypoints, size_t count) {
  std::vector<size_t> indices(keypoints.size());
  std::iota(indices.begin(), indices.end(), size_t{0});
  std::stable_sort(indices.begin(), indices.end(),
                   [&](size_t i, size_t j) { return keypoints[i].size_px > keypoints[j].size_px; });
  indices.resize(count);
  std::sort(indices.begin(), indices.end());
  return indices;
}

}  // namespace

FrameFeatures LargestFeatures(const FrameFeatures& features, size_t count) {
  if (features.keypoints.size() <= count) return features;
  FrameFeatures largest;
  largest.descriptors = {
      features.descriptors.type, features.descriptors.metric, features.descriptors.length, {}};
  const size_t length = features.descriptors.length;
  for (const size_t i : LargestIndices(features.keypoints, count)) {
    largest.keypoints.push_back(features.keypoints[i]);
    largest.colors.push_back(features.colors[i]);
    const uint8_t* row = features.descriptors.Row(i);
    largest.descriptors.data.insert(largest.descriptors.data.end(), row, row + length);
  }
  return largest;
}

}  // namespace rovio_sfm
