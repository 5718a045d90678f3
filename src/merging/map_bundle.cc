#include "rovio_sfm/merging/map_bundle.h"

#include <algorithm>
#include <limits>

#include "rovio_sfm/sfm/adjust_by_window.h"
#include "rovio_sfm/sfm/refine_intrinsics.h"

namespace rovio_sfm {
namespace {

constexpr double kMinDepth = 1e-6;

}  // namespace

Rigid3 CamFromMap(const PlacedSession& placed, uint32_t frame) {
  return TransformCamera(placed.map_from_session, placed.session->keyframe(frame).cam_from_session);
}

double LinkErrorSigmas(const Eigen::Vector3d& point_in_map, const Rigid3& cam_from_map,
                       const Keyframe& keyframe, uint32_t feature) {
  const Eigen::Vector3d x_in_cam = cam_from_map * point_in_map;
  if (!(x_in_cam.z() > kMinDepth)) return std::numeric_limits<double>::infinity();
  return (x_in_cam.hnormalized() - keyframe.points[feature]).norm() / keyframe.sigmas[feature];
}

MapBundle::MapBundle(const std::vector<PlacedSession>& sessions,
                     const std::vector<FeatureLink>& links, double max_error_sigmas) {
  for (const PlacedSession& placed : sessions) AddPart(placed);
  for (const FeatureLink& link : links) Join(link, max_error_sigmas);
  AddPoints();
  AddObservations();
}

void MapBundle::AddPart(const PlacedSession& placed) {
  part_of_[placed.session->id()] = parts_.size();
  Part part{placed, MakeGlobalBundle(*placed.session),
            static_cast<uint32_t>(problem_.cameras.size()), num_landmarks_};
  for (const uint32_t frame : part.bundle.frames) {
    problem_.cameras.push_back({CamFromMap(placed, frame), false});
  }
  num_landmarks_ += static_cast<uint32_t>(part.bundle.tracks.size());
  parts_.push_back(std::move(part));
}

const MapBundle::Part* MapBundle::PartOf(const FeatureRef& feature) const {
  const auto it = part_of_.find(feature.session);
  return it == part_of_.end() ? nullptr : &parts_[it->second];
}

std::optional<uint32_t> MapBundle::CameraOf(const FeatureRef& feature) const {
  const Part* part = PartOf(feature);
  if (part == nullptr) return std::nullopt;
  const std::vector<uint32_t>& frames = part->bundle.frames;  // ascending
  const auto it = std::lower_bound(frames.begin(), frames.end(), feature.frame);
  if (it == frames.end() || *it != feature.frame) return std::nullopt;
  return part->first_camera + static_cast<uint32_t>(it - frames.begin());
}

std::optional<uint32_t> MapBundle::LandmarkOf(const FeatureRef& feature) const {
  const Part* part = PartOf(feature);
  if (part == nullptr || ObservedLandmark(*part->placed.session, feature) == nullptr) {
    return std::nullopt;
  }
  const TrackId track = part->placed.session->keyframe(feature.frame).tracks[feature.feature];
  const std::vector<TrackId>& tracks = part->bundle.tracks;  // ascending
  const auto it = std::lower_bound(tracks.begin(), tracks.end(), track);
  if (it == tracks.end() || *it != track) return std::nullopt;
  return part->first_landmark + static_cast<uint32_t>(it - tracks.begin());
}

void MapBundle::Join(const FeatureLink& link, double max_error_sigmas) {
  const auto camera_a = CameraOf(link.a), camera_b = CameraOf(link.b);
  if (!camera_a || !camera_b) return;
  const auto a = LandmarkOf(link.a), b = LandmarkOf(link.b);
  if (a && b) {
    Unite(link, *a, *b, max_error_sigmas);
  } else if (a) {
    across_.insert({*a, link.b});
  } else if (b) {
    across_.insert({*b, link.a});
  }
}

// The cameras that see the set of a landmark, given one of its views.
std::set<uint32_t>& MapBundle::CamerasOf(uint32_t landmark, const FeatureRef& view) {
  const auto [it, is_new] = cameras_of_.try_emplace(united_.Find(landmark));
  if (!is_new) return it->second;
  for (const Observation& observation :
       ObservedLandmark(*PartOf(view)->placed.session, view)->observations) {
    const auto camera = CameraOf({view.session, observation.frame, 0});
    if (camera) it->second.insert(*camera);
  }
  return it->second;
}

// Of the landmark that one feature observes, projected at the other.
double MapBundle::ErrorAcross(const FeatureRef& from, const FeatureRef& to) const {
  const PlacedSession &source = PartOf(from)->placed, &target = PartOf(to)->placed;
  const Eigen::Vector3d& position = ObservedLandmark(*source.session, from)->position;
  return LinkErrorSigmas(source.map_from_session * position, CamFromMap(target, to.frame),
                         target.session->keyframe(to.frame), to.feature);
}

// f1 holds across sessions too: one feature per frame and point.
void MapBundle::Unite(const FeatureLink& link, uint32_t a, uint32_t b, double max_error_sigmas) {
  if (united_.Find(a) == united_.Find(b)) return;
  if (ErrorAcross(link.a, link.b) > max_error_sigmas ||
      ErrorAcross(link.b, link.a) > max_error_sigmas) {
    return;
  }
  std::set<uint32_t>&cameras_a = CamerasOf(a, link.a), &cameras_b = CamerasOf(b, link.b);
  for (const uint32_t camera : cameras_a) {
    if (cameras_b.count(camera) != 0) return;
  }
  std::set<uint32_t> united = cameras_a;
  united.insert(cameras_b.begin(), cameras_b.end());
  cameras_of_.erase(united_.Find(a));
  cameras_of_.erase(united_.Find(b));
  const uint32_t root = united_.Union(a, b);
  cameras_of_[root] = std::move(united);
}

// A point for every set of landmarks, at their mean weighted by the number of views.
void MapBundle::AddPoints() {
  point_of_.assign(num_landmarks_, 0);
  std::vector<double> weights;
  for (const Part& part : parts_) {
    const std::map<TrackId, Landmark>& landmarks = part.placed.session->landmarks();
    for (uint32_t i = 0; i < part.bundle.tracks.size(); ++i) {
      const uint32_t landmark = part.first_landmark + i, root = united_.Find(landmark);
      const Landmark& source = landmarks.at(part.bundle.tracks[i]);
      const auto weight = static_cast<double>(source.observations.size());
      if (root == landmark) {
        point_of_[landmark] = static_cast<uint32_t>(problem_.points.size());
        problem_.points.push_back(Eigen::Vector3d::Zero());
        weights.push_back(0.0);
      }
      point_of_[landmark] = point_of_[root];
      problem_.points[point_of_[root]] += weight * (part.placed.map_from_session * source.position);
      weights[point_of_[root]] += weight;
    }
  }
  for (size_t i = 0; i < weights.size(); ++i) problem_.points[i] /= weights[i];
}

void MapBundle::AddObservations() {
  for (const Part& part : parts_) {
    for (const BundleObservation& observation : part.bundle.problem.observations) {
      AddObservation(part.first_camera + observation.camera,
                     part.first_landmark + observation.point, observation.x_normalized,
                     observation.sigma);
    }
  }
  std::set<std::pair<uint32_t, uint32_t>> seen;  // (camera, point): one feature each
  for (const auto& [landmark, feature] : across_) {
    const uint32_t camera = *CameraOf(feature);
    const auto cameras = cameras_of_.find(united_.Find(landmark));
    if (cameras != cameras_of_.end() && cameras->second.count(camera) != 0) continue;
    if (!seen.insert({camera, point_of_[landmark]}).second) continue;
    const Keyframe& frame = PartOf(feature)->placed.session->keyframe(feature.frame);
    AddObservation(camera, landmark, frame.points[feature.feature], frame.sigmas[feature.feature]);
  }
}

void MapBundle::AddObservation(uint32_t camera, uint32_t landmark,
                               const Eigen::Vector2d& x_normalized, double sigma) {
  const uint32_t point = point_of_[landmark];
  const Rigid3& cam_from_map = problem_.cameras[camera].cam_from_map;
  if (!((cam_from_map * problem_.points[point]).z() > kMinDepth)) return;
  problem_.observations.push_back({camera, point, sigma, x_normalized});
}

// How far the first session's cameras go from its first one.
double MapBundle::RootExtent() const {
  const Eigen::Vector3d first = OriginInA(problem_.cameras[0].cam_from_map);
  double extent = 0.0;
  for (size_t i = 0; i < parts_[0].bundle.frames.size(); ++i) {
    const Eigen::Vector3d centre = OriginInA(problem_.cameras[i].cam_from_map);
    extent = std::max(extent, (centre - first).norm());
  }
  return extent;
}

// Scales the map about its first camera.
void MapBundle::Rescale(double factor) {
  const Eigen::Vector3d first = OriginInA(problem_.cameras[0].cam_from_map);
  const Sim3 rescaled{factor, Eigen::Quaterniond::Identity(), (1.0 - factor) * first};
  for (BundleCamera& camera : problem_.cameras) {
    camera.cam_from_map = TransformCamera(rescaled, camera.cam_from_map);
  }
  for (Eigen::Vector3d& point : problem_.points) point = rescaled * point;
}

// The solver may hold the scale by a camera of any session.
BundleReport MapBundle::Solve(const BundleOptions& options, size_t max_frames) {
  const double extent = RootExtent();
  const BundleReport report = AdjustByWindow(&problem_, options, max_frames);
  if (report.usable && extent > 0.0) Rescale(extent / RootExtent());
  return report;
}

// One for each drive; returns those of each part.
std::vector<uint32_t> MapBundle::AddIntrinsics(const std::vector<BundleIntrinsics>& by_part) {
  std::map<DriveId, uint32_t> of_drive;
  std::vector<uint32_t> of_part;
  for (size_t i = 0; i < parts_.size(); ++i) {
    const auto number = static_cast<uint32_t>(problem_.intrinsics.size());
    const auto [it, is_new] = of_drive.try_emplace(parts_[i].placed.session->drive(), number);
    if (is_new) problem_.intrinsics.push_back(by_part[i]);
    of_part.push_back(it->second);
    for (size_t j = 0; j < parts_[i].bundle.frames.size(); ++j) {
      problem_.cameras[parts_[i].first_camera + j].intrinsics = it->second;
    }
  }
  return of_part;
}

bool MapBundle::SolveIntrinsics(const std::vector<BundleIntrinsics>& by_part,
                                const BundleOptions& options) {
  const std::vector<uint32_t> of_part = AddIntrinsics(by_part);
  const double extent = RootExtent();
  if (!RefineIntrinsics(options, &problem_) || !SetCameras(of_part)) return false;
  if (extent > 0.0) Rescale(extent / RootExtent());
  return true;
}

// All or, where one is refused, none.
bool MapBundle::SetCameras(const std::vector<uint32_t>& intrinsics_of_part) const {
  std::vector<std::pair<Session*, Camera>> changed;
  for (size_t i = 0; i < parts_.size(); ++i) {
    Session* session = parts_[i].placed.session;
    const Camera before = session->camera();
    const Eigen::Vector3d& correction = problem_.intrinsics[intrinsics_of_part[i]].correction;
    if (!session->SetCamera(CorrectedCamera(before, correction))) {
      for (const auto& [other, camera] : changed) other->SetCamera(camera);
      return false;
    }
    changed.emplace_back(session, before);
  }
  return true;
}

void MapBundle::Apply() const {
  for (const Part& part : parts_) {
    const Sim3 session_from_map = Inverse(part.placed.map_from_session);
    SessionBundle bundle = part.bundle;
    for (uint32_t i = 0; i < bundle.frames.size(); ++i) {
      bundle.problem.cameras[i].cam_from_map =
          TransformCamera(session_from_map, problem_.cameras[part.first_camera + i].cam_from_map);
    }
    for (uint32_t i = 0; i < bundle.tracks.size(); ++i) {
      bundle.problem.points[i] =
          session_from_map * problem_.points[point_of_[part.first_landmark + i]];
    }
    ApplyBundle(bundle, true, part.placed.session);
  }
}

SharedLandmarks MapBundle::FindShared() const {
  std::set<uint32_t> roots;  // of two landmarks and more
  for (uint32_t landmark = 0; landmark < num_landmarks_; ++landmark) {
    if (united_.Find(landmark) != landmark) roots.insert(united_.Find(landmark));
  }
  SharedLandmarks shared;
  for (const Part& part : parts_) {
    for (uint32_t i = 0; i < part.bundle.tracks.size(); ++i) {
      const uint32_t root = united_.Find(part.first_landmark + i);
      if (roots.count(root) != 0) shared[{part.placed.session->id(), part.bundle.tracks[i]}] = root;
    }
  }
  shared.shrink_to_fit();
  return shared;
}

}  // namespace rovio_sfm
