#include "rovio_sfm/mapping/search_landmarks.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <vector>

#include "rovio_sfm/mapping/link_tracks.h"
#include "rovio_sfm/scene/feature_window.h"
#include "rovio_sfm/sfm/session_bundle.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kMinShared = 10;  // landmarks that make a frame a neighbour

// Landmarks of the covisible frames that the frame does not observe, by id.
std::set<TrackId> Candidates(const Session& session, uint32_t frame, size_t max_frames) {
  std::set<TrackId> candidates;
  for (const uint32_t other : CovisibleFrames(session, frame, max_frames + 1, kMinShared)) {
    if (other == frame) continue;
    const Keyframe& keyframe = session.keyframe(other);
    for (size_t i = 0; i < keyframe.tracks.size(); ++i) {
      if (keyframe.observed[i]) candidates.insert(keyframe.tracks[i]);
    }
  }
  const Keyframe& self = session.keyframe(frame);
  for (size_t i = 0; i < self.tracks.size(); ++i) {
    if (self.observed[i]) candidates.erase(self.tracks[i]);
  }
  return candidates;
}

// The landmark's first view not before the frame.
std::vector<Observation>::const_iterator ViewFrom(const Landmark& landmark, uint32_t frame) {
  return std::lower_bound(landmark.observations.begin(), landmark.observations.end(),
                          Observation{frame, 0});
}

// The view of the landmark nearest in time to the frame; of two as near the older.
Observation NearestView(const Landmark& landmark, uint32_t frame) {
  const auto next = ViewFrom(landmark, frame);
  if (next == landmark.observations.begin()) return *next;
  const Observation& last = *std::prev(next);
  const bool is_last =
      next == landmark.observations.end() || frame - last.frame <= next->frame - frame;
  return is_last ? last : *next;
}

bool IsSeenIn(const Landmark& landmark, uint32_t frame) {
  const auto view = ViewFrom(landmark, frame);
  return view != landmark.observations.end() && view->frame == frame;
}

// The feature that shows the landmark, if the window has one.
std::optional<uint32_t> FindIn(const FeatureWindow& window, const Landmark& landmark,
                               const uint8_t* appearance) {
  const Eigen::Vector3d x_in_cam = window.frame.cam_from_session * landmark.position;
  if (!(x_in_cam.z() > 1e-9)) return std::nullopt;
  return FindFeature(window, x_in_cam.hnormalized(), appearance);
}

// Makes the feature an observation of the landmark, whatever track it is in.
void Attach(TrackId id, const Observation& feature, const FilterF2Options& f2, Session* session,
            SearchReport* report) {
  const TrackId own = session->keyframe(feature.frame).tracks[feature.feature];
  if (own == id) {
    session->AddObservation(id, feature);
    ++report->num_added;
  } else if (own != 0 && session->FindLandmark(own) != nullptr) {
    if (TryUniteLandmarks(own, id, f2, session)) ++report->num_united;
  } else {
    const bool attached =
        own == 0 ? session->MoveToTrack(feature, id) : session->UniteTracks(own, id);
    const TrackId root = session->RootOf(id);
    if (!attached || session->landmarks().count(root) == 0) return;
    session->AddObservation(root, feature);
    ++report->num_added;
  }
}

}  // namespace

SearchReport SearchLandmarks(uint32_t frame, const SearchLandmarksOptions& options,
                             const FrameStore& store, Session* session) {
  SearchReport report;
  DescriptorReader reader(store, session->drive());
  const Descriptors* descriptors = reader.Of(frame);
  if (descriptors == nullptr) return report;
  const double radius = options.radius_px / session->camera().MeanFocal();
  const FeatureGrid grid(session->keyframe(frame).points, radius);
  for (const TrackId id : Candidates(*session, frame, options.max_frames)) {
    const auto it = session->landmarks().find(id);
    // A union of this very search may have removed it or have found it here.
    if (it == session->landmarks().end() || IsSeenIn(it->second, frame)) continue;
    const uint8_t* appearance = reader.Row(NearestView(it->second, frame), descriptors->length);
    if (appearance == nullptr) continue;
    ++report.num_candidates;
    const FeatureWindow window{session->keyframe(frame),
                               grid,
                               *descriptors,
                               radius,
                               options.max_distance,
                               options.max_ratio,
                               options.max_error_sigmas};
    const auto feature = FindIn(window, it->second, appearance);
    if (feature) Attach(id, {frame, *feature}, options.f2, session, &report);
  }
  return report;
}

}  // namespace rovio_sfm
