#include "rovio_sfm/sfm/prune_landmarks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "rovio_sfm/geometry/triangulate.h"
#include "rovio_sfm/util/median.h"

namespace rovio_sfm {
namespace {

// A session's keyframes, each looked up once: a landmark has up to hundreds of views. Only while no
// keyframe comes or goes.
class FrameTable {
 public:
  explicit FrameTable(const Session& session) : session_(session) {}

  const Keyframe& Find(uint32_t index) {
    const Keyframe*& frame = frames_[index];
    if (frame == nullptr) frame = &session_.keyframe(index);
    return *frame;
  }

 private:
  const Session& session_;
  std::unordered_map<uint32_t, const Keyframe*> frames_;  // look-up only
};

double ErrorSigmas(const Keyframe& frame, uint32_t feature, const Eigen::Vector3d& position) {
  const auto error = ReprojectionError(frame.cam_from_session, frame.points[feature], position);
  return error ? *error / frame.sigmas[feature] : HUGE_VAL;
}

bool HasParallax(const Landmark& landmark, double min_parallax_rad, FrameTable* frames) {
  const std::vector<Observation>& views = landmark.observations;
  const auto center_of = [frames](const Observation& view) {
    return OriginInA(frames->Find(view.frame).cam_from_session);
  };
  // The first and the last view are mostly the widest apart: try the far ones first.
  if (ParallaxAngle(center_of(views.front()), center_of(views.back()), landmark.position) >=
      min_parallax_rad) {
    return true;
  }
  std::vector<Eigen::Vector3d> centers;
  for (const Observation& view : views) centers.push_back(center_of(view));
  for (size_t gap = centers.size() - 1; gap > 0; --gap) {
    for (size_t i = 0; i + gap < centers.size(); ++i) {
      if (ParallaxAngle(centers[i], centers[i + gap], landmark.position) >= min_parallax_rad) {
        return true;
      }
    }
  }
  return false;
}

void PruneLandmark(TrackId id, const LandmarkLimits& limits, FrameTable* frames, Session* session,
                   PruneReport* report) {
  const Landmark& landmark = session->landmarks().at(id);
  const size_t count = landmark.observations.size();
  std::vector<Observation> bad;
  for (const Observation& view : landmark.observations) {
    const double error = ErrorSigmas(frames->Find(view.frame), view.feature, landmark.position);
    if (!(error <= limits.max_error_sigmas)) bad.push_back(view);
  }
  if (count - bad.size() < 2) {
    session->RemoveLandmark(id);
  } else {
    for (const Observation& observation : bad) session->RemoveObservation(id, observation);
    if (!HasParallax(landmark, limits.min_parallax_rad, frames)) session->RemoveLandmark(id);
  }
  const Landmark* after = session->FindLandmark(id);
  report->num_landmarks += after == nullptr ? 1 : 0;
  report->num_observations +=
      static_cast<uint32_t>(count - (after == nullptr ? 0 : after->observations.size()));
}

constexpr uint32_t kMinHold = 10;  // landmarks by which a keyframe hangs on others

// Grows from one keyframe over all that see kMinHold landmarks of those reached before, up to the
// number that there are at most.
std::set<uint32_t> HangingTogether(const Session& session, uint32_t first, size_t max_count) {
  std::set<uint32_t> reached = {first};
  std::vector<uint32_t> open = {first};
  std::set<TrackId> seen;
  std::map<uint32_t, uint32_t> num_seen;  // by keyframe not yet reached
  while (!open.empty() && reached.size() < max_count) {
    const Keyframe& keyframe = session.keyframe(open.back());
    open.pop_back();
    for (size_t i = 0; i < keyframe.tracks.size(); ++i) {
      if (!keyframe.observed[i] || !seen.insert(keyframe.tracks[i]).second) continue;
      for (const Observation& view : session.landmarks().at(keyframe.tracks[i]).observations) {
        if (reached.count(view.frame) != 0 || ++num_seen[view.frame] < kMinHold) continue;
        reached.insert(view.frame);
        open.push_back(view.frame);
      }
    }
  }
  return reached;
}

// All keyframes with a pose but those of the largest part that hangs together.
std::set<uint32_t> LooseFrames(const Session& session) {
  std::set<uint32_t> posed, largest;
  for (const auto& [index, keyframe] : session.keyframes()) {
    if (!keyframe.weak) posed.insert(index);
  }
  const size_t num_posed = posed.size();
  for (std::set<uint32_t> left = posed; left.size() > largest.size();) {
    const std::set<uint32_t> part = HangingTogether(session, *left.begin(), num_posed);
    for (const uint32_t frame : part) left.erase(frame);
    if (part.size() > largest.size()) largest = part;
  }
  for (const uint32_t frame : largest) posed.erase(frame);
  return posed;
}

}  // namespace

PruneReport PruneLandmarks(const std::vector<TrackId>& tracks, const LandmarkLimits& limits,
                           Session* session) {
  PruneReport report;
  FrameTable frames(*session);
  for (const TrackId id : tracks) {
    if (session->landmarks().count(id) == 1) PruneLandmark(id, limits, &frames, session, &report);
  }
  return report;
}

PruneReport PruneAllLandmarks(const LandmarkLimits& limits, Session* session) {
  std::vector<TrackId> tracks;
  for (const auto& [id, landmark] : session->landmarks()) tracks.push_back(id);
  PruneReport report = PruneLandmarks(tracks, limits, session);
  for (const uint32_t frame : LooseFrames(*session)) {
    session->RemoveKeyframe(frame);
    ++report.num_frames;
  }
  return report;
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
