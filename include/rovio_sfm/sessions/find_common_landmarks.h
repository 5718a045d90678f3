#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/scene/match.h"
#include "rovio_sfm/scene/session.h"

namespace rovio_sfm {

// A landmark as a frame of its own session knows it.
struct SeenLandmark {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // in the session, map units
  double sigma_log_distance = 0.0;  // 1 sigma of log(distance from the frame), from its parallax
};

// A feature of a registered keyframe, and the landmark that it observes, if any.
struct CrossView {
  Observation observation;  // frame and feature
  TrackId track = 0;        // root; 0 none
  Rigid3 cam_from_session;
  Eigen::Vector2d x_normalized = Eigen::Vector2d::Zero();
  double sigma = 1.0;  // normalised units, above 0
  std::optional<SeenLandmark> landmark;
};

// A feature of session a and one of session b that show the same point, by appearance and epipolar
// geometry.
struct CrossMatch {
  CrossView a, b;
};

// True where both features observe landmarks.
inline bool IsCommon(const CrossMatch& match) { return match.a.landmark && match.b.landmark; }

// What the sessions know about the features matched between two of their keyframes; matches.a are
// features of frame_a. Nothing where a frame is unknown to its session, or weak; matches whose
// features do not exist are passed over. Frames of one session may be given too (a loop).
std::vector<CrossMatch> FindCrossMatches(const Session& a, const Session& b, const FrameId& frame_a,
                                         const FrameId& frame_b,
                                         const std::vector<FeatureMatch>& matches);

}  // namespace rovio_sfm
