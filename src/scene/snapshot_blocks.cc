#include "rovio_sfm/scene/snapshot_blocks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rovio_sfm {
namespace {

constexpr size_t kMaxViewsForParallax = 16;

FrameSnapshot Snap(uint32_t index, const Keyframe& frame) {
  FrameSnapshot snapshot;
  snapshot.index = index;
  snapshot.stamp_ns = frame.stamp_ns;
  snapshot.image_name = frame.image_name;
  snapshot.kind = FrameKind::kKeyframe;
  snapshot.weak = frame.weak;
  snapshot.cam_from_session = frame.cam_from_session;
  snapshot.base_from_camera = frame.base_from_camera;
  snapshot.num_observations = frame.num_observed;
  return snapshot;
}

FrameSnapshot Snap(uint32_t index, const LightFrame& frame, const Rigid3& reference_from_session) {
  FrameSnapshot snapshot;
  snapshot.index = index;
  snapshot.stamp_ns = frame.stamp_ns;
  snapshot.image_name = frame.image_name;
  snapshot.kind = FrameKind::kLight;
  snapshot.cam_from_session = frame.cam_from_reference * reference_from_session;
  snapshot.base_from_camera = frame.base_from_camera;
  snapshot.num_observations = frame.num_inliers;
  return snapshot;
}

double MaxParallax(const std::vector<Eigen::Vector3d>& rays) {
  const size_t step = 1 + (rays.size() - 1) / kMaxViewsForParallax;
  double cosine = 1.0;
  for (size_t i = 0; i < rays.size(); i += step) {
    for (size_t j = i + step; j < rays.size(); j += step) {
      cosine = std::min(cosine, rays[i].dot(rays[j]));
    }
    cosine = std::min(cosine, rays[i].dot(rays.back()));
  }
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

LandmarkSnapshot Snap(const Camera& camera, const std::map<uint32_t, Keyframe>& keyframes,
                      TrackId id, const Landmark& landmark) {
  LandmarkSnapshot snapshot;
  snapshot.id = id;
  snapshot.position = landmark.position;
  snapshot.color = landmark.color;
  snapshot.num_views = static_cast<uint32_t>(landmark.observations.size());
  std::vector<Eigen::Vector3d> rays;
  double sum = 0.0;
  for (const Observation& observation : landmark.observations) {
    const Keyframe& frame = keyframes.at(observation.frame);
    const Eigen::Vector3d x_in_cam = frame.cam_from_session * landmark.position;
    const double squared =
        (x_in_cam.hnormalized() - frame.points[observation.feature]).squaredNorm();
    snapshot.squared_error_normalized += squared;
    sum += std::sqrt(squared);
    rays.push_back((frame.cam_from_session.rotation.conjugate() * x_in_cam).normalized());
  }
  snapshot.mean_error_px =
      camera.MeanFocal() * sum / static_cast<double>(landmark.observations.size());
  snapshot.max_parallax_rad = MaxParallax(rays);
  return snapshot;
}

template <typename Blocks>
auto InOrder(const Blocks& cache) {
  std::vector<typename Blocks::mapped_type> blocks;
  for (const auto& [number, block] : cache) blocks.push_back(block);
  return blocks;
}

}  // namespace

std::vector<std::shared_ptr<const FrameBlock>> UpdateFrameBlocks(
    const std::map<uint32_t, Keyframe>& keyframes,
    const std::map<uint32_t, LightFrame>& light_frames, FrameBlocks* cache) {
  std::map<uint64_t, std::map<uint32_t, FrameSnapshot>> fresh;
  for (const auto& [index, frame] : keyframes) {
    const uint64_t number = index / kFramesPerBlock;
    if (cache->count(number) == 0) fresh[number].emplace(index, Snap(index, frame));
  }
  for (const auto& [index, frame] : light_frames) {
    const uint64_t number = index / kFramesPerBlock;
    if (cache->count(number) != 0) continue;
    const Rigid3& reference = keyframes.at(frame.reference).cam_from_session;
    fresh[number].emplace(index, Snap(index, frame, reference));
  }
  for (const auto& [number, frames] : fresh) {
    auto block = std::make_shared<FrameBlock>();
    for (const auto& [index, frame] : frames) block->push_back(frame);
    cache->emplace(number, std::move(block));
  }
  return InOrder(*cache);
}

std::vector<std::shared_ptr<const LandmarkBlock>> UpdateLandmarkBlocks(
    const Camera& camera, const std::map<uint32_t, Keyframe>& keyframes,
    const std::map<TrackId, Landmark>& landmarks, LandmarkBlocks* cache) {
  for (auto it = landmarks.begin(); it != landmarks.end();) {
    const uint64_t number = it->first / kLandmarksPerBlock;
    const auto end = landmarks.lower_bound((number + 1) * kLandmarksPerBlock);
    if (cache->count(number) == 0) {
      auto block = std::make_shared<LandmarkBlock>();
      for (; it != end; ++it) block->push_back(Snap(camera, keyframes, it->first, it->second));
      cache->emplace(number, std::move(block));
    }
    it = end;
  }
  return InOrder(*cache);
}

}  // namespace rovio_sfm
