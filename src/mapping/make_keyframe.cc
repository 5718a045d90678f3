#include "rovio_sfm/mapping/make_keyframe.h"

#include "rovio_sfm/sfm/feature_noise.h"

namespace rovio_sfm {

double FeatureSigma(const Keypoint& keypoint, const Camera& camera, const MapperOptions& options) {
  return SigmaOf(keypoint, camera.MeanFocal(),
                 {options.pixel_sigma_px, options.sigma_size_px, options.sigma_exponent});
}

PoseObservation ObserveLandmark(const FrameEvent& event, uint32_t feature,
                                const Eigen::Vector3d& position, const MapperOptions& options) {
  const Keypoint& keypoint = event.features->keypoints[feature];
  return {position, keypoint.x_normalized, FeatureSigma(keypoint, event.camera, options)};
}

Keyframe MakeKeyframe(const FrameEvent& event, const Rigid3& cam_from_session,
                      const MapperOptions& options) {
  Keyframe frame;
  frame.stamp_ns = event.stamp_ns;
  frame.image_name = event.image_name;
  frame.cam_from_session = cam_from_session;
  frame.odometry = event.odometry;
  frame.base_from_camera = event.base_from_camera;
  frame.tracks = event.tracks;
  frame.colors = event.features->colors;
  for (const Keypoint& keypoint : event.features->keypoints) {
    frame.points.push_back(keypoint.x_normalized);
    frame.sigmas.push_back(FeatureSigma(keypoint, event.camera, options));
  }
  return frame;
}

LightFrame MakeLightFrame(const FrameEvent& event) {
  LightFrame frame;
  frame.stamp_ns = event.stamp_ns;
  frame.image_name = event.image_name;
  frame.base_from_camera = event.base_from_camera;
  for (size_t i = 0; i < event.tracks.size(); ++i) {
    if (event.tracks[i] == 0) continue;
    frame.tracks.push_back(event.tracks[i]);
    frame.points.push_back(event.features->keypoints[i].x_normalized);
  }
  return frame;
}

}  // namespace rovio_sfm
