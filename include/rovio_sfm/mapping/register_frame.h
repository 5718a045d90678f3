#pragma once

#include <optional>
#include <vector>

#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/scene/session.h"
#include "rovio_sfm/sfm/refine_pose.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {

struct Registration {
  Rigid3 cam_from_session;
  uint32_t num_matches = 0;  // 2D-3D
  uint32_t num_inliers = 0;
};

// Another session of the same drive and map: it may know landmarks of the same tracks.
struct Sibling {
  const Session* session = nullptr;
  Sim3 session_from_sibling;
};

// The pose of a new keyframe from all its tracks that have landmarks (§3.7.1); nothing where fewer
// than options.min_inliers agree.
std::optional<Registration> RegisterKeyframe(const FrameEvent& event, const MapperOptions& options,
                                             const Session& session);

// The pose of a frame from what it sees of landmarks, by RANSAC on a stream of its own; nothing
// where fewer than options.min_inliers agree.
std::optional<Registration> RegisterObservations(const std::vector<PoseObservation>& observations,
                                                 uint64_t stream, const MapperOptions& options);

// The pose of a keyframe that the session already holds, from its members of tracks with landmarks.
std::optional<Registration> RegisterAgain(uint32_t frame, const MapperOptions& options,
                                          const Session& session);

// Poses a light frame relative to the newest keyframe before it, by the landmarks of the session
// and of its siblings: from a predicted pose where there is one, else by RANSAC. False, with the
// frame as it was, where too few of the landmarks agree.
bool PoseLightFrame(uint32_t index, const std::optional<Rigid3>& predicted_cam_from_session,
                    const MapperOptions& options, LightFrame* frame, const Session& session,
                    const std::vector<Sibling>& siblings = {});

// Resects all light frames of the session from their present poses; those that fail keep theirs.
void RefineLightFrames(const MapperOptions& options, Session* session);

}  // namespace rovio_sfm
