#pragma once

#include <vector>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/scene/frame.h"

namespace rovio_sfm {

constexpr double kFocalPx = 500.0;

struct CameraPair {
  FrameFeatures a, b;
  Rigid3 b_from_a;
};

// Two cameras side by side that have seen nothing yet; descriptors are SURF's, of 64 bytes.
inline CameraPair SideBySide() {
  CameraPair pair;
  pair.a.descriptors.type = pair.b.descriptors.type = DescriptorType::kSurf;
  pair.a.descriptors.length = pair.b.descriptors.length = 64;
  pair.b_from_a.translation = {-1.0, 0.0, 0.0};
  return pair;
}

inline void AddFeature(const Eigen::Vector3d& x_in_cam, const std::vector<uint8_t>& descriptor,
                       FrameFeatures* features) {
  Keypoint keypoint;
  keypoint.x_normalized = x_in_cam.hnormalized();
  features->keypoints.push_back(keypoint);
  features->descriptors.data.insert(features->descriptors.data.end(), descriptor.begin(),
                                    descriptor.end());
}

// Of a descriptor whose bytes all have this value.
inline void AddFeature(const Eigen::Vector3d& x_in_cam, uint8_t value, FrameFeatures* features) {
  AddFeature(x_in_cam, std::vector<uint8_t>(64, value), features);
}

}  // namespace rovio_sfm
