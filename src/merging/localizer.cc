#include "rovio_sfm/merging/localizer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <set>
#include <utility>

#include "rovio_sfm/mapping/make_keyframe.h"
#include "rovio_sfm/mapping/register_frame.h"

namespace rovio_sfm {

std::optional<Localization> Localizer::Add(const FrameEvent& event) {
  ++num_frames_;
  Drive& drive = drives_[event.id.drive];
  for (const TrackLink& link : event.links) {
    const auto known = drive.shown.find(link.a);
    if (known != drive.shown.end()) drive.shown.emplace(link.b, known->second);
  }
  drive.recent.push_back(event);
  if (drive.recent.size() > kRecentFrames) {
    drive.posed.erase(drive.recent.front().id.index);
    drive.recent.pop_front();
  }
  ForgetOldTracks(&drive);
  std::optional<Localization> pose = Pose(event, ViewsOf(event, drive), &drive);
  drive.early.erase(drive.early.begin(), drive.early.lower_bound(event.id.index));
  if (const auto early = drive.early.extract(event.id.index)) {
    if (auto by_match = Pose(event, ViewsOf(early.mapped()), &drive)) pose = by_match;
  }
  return pose;
}

std::optional<Localization> Localizer::Add(const PlaceMatch& match) {
  Drive& drive = drives_[match.query.drive];
  const auto event =
      std::find_if(drive.recent.begin(), drive.recent.end(),
                   [&](const FrameEvent& recent) { return recent.id == match.query; });
  if (event == drive.recent.end()) {
    const bool may_come = drive.recent.empty() || drive.recent.back().id < match.query;
    if (may_come && drive.early.size() < kRecentFrames) {
      drive.early.insert_or_assign(match.query.index, match);
    }
    return std::nullopt;
  }
  return Pose(*event, ViewsOf(match), &drive);
}

const Landmark* Localizer::Find(const LandmarkRef& ref) const {
  const Session* session = maps_->sessions().Find(ref.session);
  return session == nullptr ? nullptr : session->FindLandmark(ref.track);
}

std::vector<Localizer::View> Localizer::ViewsOf(const FrameEvent& event, const Drive& drive) const {
  std::vector<View> views;
  for (uint32_t i = 0; i < event.tracks.size(); ++i) {
    const auto shown = drive.shown.find(event.tracks[i]);
    if (event.tracks[i] != 0 && shown != drive.shown.end()) views.push_back({i, shown->second});
  }
  return views;
}

std::vector<Localizer::View> Localizer::ViewsOf(const PlaceMatch& match) const {
  std::map<uint32_t, LandmarkRef> by_feature;  // of the nearest matched frame
  for (const OverlapPair& pair : match.pairs) {
    const Session* session = maps_->sessions().FindHolder(pair.other);
    if (session == nullptr) continue;
    for (const FeatureMatch& inlier : pair.inliers) {
      const FeatureRef feature{session->id(), pair.other.index, inlier.a};
      if (ObservedLandmark(*session, feature) == nullptr) continue;
      const TrackId track = session->keyframe(pair.other.index).tracks[inlier.a];
      by_feature.emplace(inlier.b, LandmarkRef{session->id(), track});
    }
  }
  std::vector<View> views;
  for (const auto& [feature, landmark] : by_feature) views.push_back({feature, landmark});
  return views;
}

// In the gauge of the map that most of the landmarks belong to.
std::optional<Localization> Localizer::Pose(const FrameEvent& event, const std::vector<View>& views,
                                            Drive* drive) {
  std::map<SessionId, uint32_t> seen;
  for (const View& view : views) ++seen[view.landmark.session];
  if (seen.empty()) return std::nullopt;
  const auto most = std::max_element(
      seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  const MapPlace place = maps_->PlaceOf(most->first);
  std::vector<PoseObservation> observations;
  for (const View& view : views) {
    const Landmark* landmark = Find(view.landmark);
    const MapPlace other = maps_->PlaceOf(view.landmark.session);
    if (landmark == nullptr || !(other.map == place.map)) continue;
    if (view.feature >= event.features->keypoints.size()) continue;
    observations.push_back(ObserveLandmark(event, view.feature,
                                           other.map_from_session * landmark->position, options_));
  }
  const auto registration = RegisterObservations(observations, event.id.index, options_);
  if (!registration) return std::nullopt;
  Remember(event, views, place.map, registration->cam_from_session, drive);
  if (drive->posed.insert(event.id.index).second) ++num_posed_;
  Localization pose;
  pose.id = event.id;
  pose.stamp_ns = event.stamp_ns;
  pose.image_name = event.image_name;
  pose.odometry = event.odometry;
  pose.base_from_camera = event.base_from_camera;
  pose.session = most->first;
  pose.cam_from_session =
      TransformCamera(Inverse(place.map_from_session), registration->cam_from_session);
  pose.num_matches = registration->num_matches;
  pose.num_inliers = registration->num_inliers;
  return pose;
}

// What agrees with the pose rides on with its track; what does not is forgotten.
void Localizer::Remember(const FrameEvent& event, const std::vector<View>& views, MapId map,
                         const Rigid3& cam_from_map, Drive* drive) const {
  const double max_error_sigmas = options_.resect.threshold_px / options_.pixel_sigma_px;
  for (const View& view : views) {
    if (view.feature >= event.tracks.size() || event.tracks[view.feature] == 0) continue;
    const Landmark* landmark = Find(view.landmark);
    const MapPlace place = maps_->PlaceOf(view.landmark.session);
    if (landmark == nullptr || !(place.map == map)) continue;
    const Eigen::Vector3d in_camera = cam_from_map * (place.map_from_session * landmark->position);
    const Keypoint& keypoint = event.features->keypoints[view.feature];
    const double sigma = FeatureSigma(keypoint, event.camera, options_);
    const bool agrees =
        in_camera.z() > 0.0 &&
        (in_camera.hnormalized() - keypoint.x_normalized).norm() <= max_error_sigmas * sigma;
    if (agrees) {
      drive->shown[event.tracks[view.feature]] = view.landmark;
    } else {
      drive->shown.erase(event.tracks[view.feature]);
    }
  }
}

// Tracks that none of the newest frames holds come no more.
void Localizer::ForgetOldTracks(Drive* drive) const {
  if (drive->recent.back().id.index % kRecentFrames != 0) return;
  std::set<TrackId> alive;
  for (const FrameEvent& event : drive->recent) {
    alive.insert(event.tracks.begin(), event.tracks.end());
  }
  for (auto it = drive->shown.begin(); it != drive->shown.end();) {
    it = alive.count(it->first) == 0 ? drive->shown.erase(it) : std::next(it);
  }
}

}  // namespace rovio_sfm
