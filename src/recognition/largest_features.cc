#include "rovio_sfm/recognition/largest_features.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "rovio_sfm/scene/append_feature.h"

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

std::shared_ptr<const FrameFeatures> LargestFeatures(std::shared_ptr<const FrameFeatures> features,
                                                     size_t count) {
  if (features->keypoints.size() <= count) return features;
  auto largest = std::make_shared<FrameFeatures>();
  const Descriptors& descriptors = features->descriptors;
  largest->descriptors = {descriptors.type, descriptors.metric, descriptors.length, {}};
  for (const size_t i : LargestIndices(features->keypoints, count)) {
    AppendFeature(*features, i, largest.get());
  }
  return largest;
}

}  // namespace rovio_sfm
