#pragma once

#include <optional>

#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/scene/session.h"
#include "rovio_sfm/sfm/refine_pose.h"

namespace rovio_sfm {

// The standard deviation of a feature's position in normalised units: the pixel's sigma, growing
// with the feature's size.
double FeatureSigma(const Keypoint& keypoint, const Camera& camera, const MapperOptions& options);

// A landmark as a feature of the frame shows it.
PoseObservation ObserveLandmark(const FrameEvent& event, uint32_t feature,
                                const Eigen::Vector3d& position, const MapperOptions& options);

// A keyframe for the session from an event, not weak, with the pose given.
Keyframe MakeKeyframe(const FrameEvent& event, const Rigid3& cam_from_session,
                      const MapperOptions& options);

// A light frame without a pose yet: what it saw, of tracks only.
LightFrame MakeLightFrame(const FrameEvent& event);

}  // namespace rovio_sfm
