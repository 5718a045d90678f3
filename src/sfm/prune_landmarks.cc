#include "rovio_sfm/sfm/prune_landmarks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rovio_sfm/geometry/triangulate.h"
#include "rovio_sfm/util/median.h"

namespace rovio_sfm {
namespace {

double ErrorSigmas(const Session& session, const Observation& observation,
                   const Eigen::Vector3d& position) {
  const Keyframe& frame = session.keyframe(observation.frame);
  const auto error =
      ReprojectionError(frame.cam_from_session, frame.points[observation.feature], position);
  return error ? *error / frame.sigmas[observation.feature] : HUGE_VAL;
}

bool HasParallax(const Session& session, const Landmark& landmark, double min_parallax_rad) {
  std::vector<Eigen::Vector3d> centers;
  for (const Observation& observation : landmark.observations) {
    centers.push_back(OriginInA(session.keyframe(observation.frame).cam_from_session));
  }
  // The first and the last view are mostly the widest apart: try the far ones first.
  for (size_t gap = centers.size() - 1; gap > 0; --gap) {
    for (size_t i = 0; i + gap < centers.size(); ++i) {
      if (ParallaxAngle(centers[i], centers[i + gap], landmark.position) >= min_parallax_rad) {
        return true;
      }
    }
  }
  return false;
}

void PruneLandmark(TrackId id, const LandmarkLimits& limits, Session* session,
                   PruneReport* report) {
  const Landmark before = session->landmarks().at(id);
  const size_t count = before.observations.size();
  std::vector<Observation> bad;
  for (const Observation& observation : before.observations) {
    if (!(ErrorSigmas(*session, observation, before.position) <= limits.max_error_sigmas)) {
      bad.push_back(observation);
    }
  }
  if (count - bad.size() < 2) {
    session->RemoveLandmark(id);
  } else {
    for (const Observation& observation : bad) session->RemoveObservation(id, observation);
    if (!HasParallax(*session, session->landmarks().at(id), limits.min_parallax_rad)) {
      session->RemoveLandmark(id);
    }
  }
  const Landmark* after = session->FindLandmark(id);
  report->num_landmarks += after == nullptr ? 1 : 0;
  report->num_observations +=
      static_cast<uint32_t>(count - (after == nullptr ? 0 : after->observations.size()));
}

}  // namespace

PruneReport PruneLandmarks(const std::vector<TrackId>& tracks, const LandmarkLimits& limits,
                           Session* session) {
  PruneReport report;
  for (const TrackId id : tracks) {
    if (session->landmarks().count(id) == 1) PruneLandmark(id, limits, session, &report);
  }
  return report;
}

PruneReport PruneAllLandmarks(const LandmarkLimits& limits, Session* session) {
  std::vector<TrackId> tracks;
  for (const auto& [id, landmark] : session->landmarks()) tracks.push_back(id);
  return PruneLandmarks(tracks, limits, session);
}

double ResidualSpread(const Session& session) {
  std::vector<double> residuals;
  for (const auto& [id, landmark] : session.landmarks()) {
    for (const Observation& observation : landmark.observations) {
      const Keyframe& frame = session.keyframe(observation.frame);
      const Eigen::Vector3d x = frame.cam_from_session * landmark.position;
      const Eigen::Vector2d error =
          (x.hnormalized() - frame.points[observation.feature]) / frame.sigmas[observation.feature];
      residuals.push_back(std::abs(error.x()));
      residuals.push_back(std::abs(error.y()));
    }
  }
  if (residuals.empty()) return 0.0;
  return 1.4826 * Median(std::move(residuals));
}

}  // namespace rovio_sfm
