#include "rovio_sfm/pipeline/search_landmarks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include "rovio_sfm/geometry/triangulate.h"
#include "rovio_sfm/pipeline/link_tracks.h"
#include "rovio_sfm/sfm/session_bundle.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kMinShared = 10;  // landmarks that make a frame a neighbour

// The features of one frame by cells of the plane z = 1.
class FeatureGrid {
 public:
  FeatureGrid(const std::vector<Eigen::Vector2d>& points, double cell) : cell_(cell) {
    for (uint32_t i = 0; i < points.size(); ++i) cells_[Key(points[i])].push_back(i);
  }

  // The features of the cells that a window of one cell's half width touches.
  std::vector<uint32_t> Near(const Eigen::Vector2d& point) const {
    std::vector<uint32_t> near;
    const auto [x, y] = Key(point);
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const auto it = cells_.find({x + dx, y + dy});
        if (it != cells_.end()) near.insert(near.end(), it->second.begin(), it->second.end());
      }
    }
    return near;
  }

 private:
  std::pair<int, int> Key(const Eigen::Vector2d& point) const {
    return {static_cast<int>(std::floor(point.x() / cell_)),
            static_cast<int>(std::floor(point.y() / cell_))};
  }

  double cell_;
  std::map<std::pair<int, int>, std::vector<uint32_t>> cells_;
};

// Descriptors by frame, fetched once per search.
class DescriptorReader {
 public:
  DescriptorReader(const FrameStore& store, const DriveId& drive) : store_(store), drive_(drive) {}

  // Null where there is none of that length.
  const uint8_t* Row(const Observation& observation, uint32_t length) {
    const Descriptors* descriptors = Of(observation.frame);
    const bool known = descriptors != nullptr && descriptors->length == length;
    return known ? descriptors->Row(observation.feature) : nullptr;
  }

  // Null where the frame or descriptors of bytes under L2 are missing.
  const Descriptors* Of(uint32_t frame) {
    auto [it, is_new] = cache_.try_emplace(frame);
    if (is_new) it->second = store_.Get({drive_, frame});
    if (it->second == nullptr || it->second->descriptors.Count() == 0 ||
        it->second->descriptors.metric != DescriptorMetric::kL2) {
      return nullptr;
    }
    return &it->second->descriptors;
  }

 private:
  const FrameStore& store_;
  const DriveId& drive_;
  std::map<uint32_t, std::shared_ptr<const FrameFeatures>> cache_;
};

float Distance(const uint8_t* a, const uint8_t* b, uint32_t length) {
  int sum = 0;
  for (uint32_t i = 0; i < length; ++i) {
    const int difference = static_cast<int>(a[i]) - static_cast<int>(b[i]);
    sum += difference * difference;
  }
  return std::sqrt(static_cast<float>(sum));
}

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

// The view of the landmark nearest in time to the frame.
Observation NearestView(const Landmark& landmark, uint32_t frame) {
  const auto distance = [&](const Observation& o) {
    return o.frame > frame ? o.frame - frame : frame - o.frame;
  };
  return *std::min_element(
      landmark.observations.begin(), landmark.observations.end(),
      [&](const Observation& a, const Observation& b) { return distance(a) < distance(b); });
}

bool IsSeenIn(const Landmark& landmark, uint32_t frame) {
  return std::any_of(landmark.observations.begin(), landmark.observations.end(),
                     [&](const Observation& o) { return o.frame == frame; });
}

struct Window {
  const Keyframe& frame;
  const FeatureGrid& grid;
  const Descriptors& descriptors;
  double radius;  // normalised
};

// The feature of the window that looks like the landmark, if one clearly does.
std::optional<uint32_t> FindFeature(const Window& window, const Landmark& landmark,
                                    const uint8_t* appearance,
                                    const SearchLandmarksOptions& options) {
  const Eigen::Vector3d x_in_cam = window.frame.cam_from_session * landmark.position;
  if (!(x_in_cam.z() > 1e-9)) return std::nullopt;
  const Eigen::Vector2d predicted = x_in_cam.hnormalized();
  float best = options.max_distance, second = HUGE_VALF;
  std::optional<uint32_t> found;
  for (const uint32_t i : window.grid.Near(predicted)) {
    const double error = (window.frame.points[i] - predicted).norm();
    if (error > window.radius) continue;
    const float distance =
        Distance(appearance, window.descriptors.Row(i), window.descriptors.length);
    if (distance < best) {
      second = found ? best : second;
      best = distance;
      found = i;
    } else {
      second = std::min(second, distance);
    }
  }
  if (!found || best > options.max_ratio * second) return std::nullopt;
  const double error = (window.frame.points[*found] - predicted).norm();
  if (error > options.max_error_sigmas * window.frame.sigmas[*found]) return std::nullopt;
  return found;
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
    const Window window{session->keyframe(frame), grid, *descriptors, radius};
    const auto feature = FindFeature(window, it->second, appearance, options);
    if (feature) Attach(id, {frame, *feature}, options.f2, session, &report);
  }
  return report;
}

}  // namespace rovio_sfm
