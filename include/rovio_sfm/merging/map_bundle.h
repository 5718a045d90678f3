#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/scene/feature_link.h"
#include "rovio_sfm/scene/map_snapshot.h"
#include "rovio_sfm/scene/session.h"
#include "rovio_sfm/sfm/session_bundle.h"
#include "rovio_sfm/util/union_find.h"

namespace rovio_sfm {

// A session of a map, and where it stands there. Borrowed.
struct PlacedSession {
  Session* session = nullptr;
  Sim3 map_from_session;
};

// The camera of a session's keyframe in the map.
Rigid3 CamFromMap(const PlacedSession& placed, uint32_t frame);

// How far a point projects from a feature of any session's keyframe, in sigmas of the feature;
// infinite behind the camera.
double LinkErrorSigmas(const Eigen::Vector3d& point_in_map, const Rigid3& cam_from_map,
                       const Keyframe& keyframe, uint32_t feature);

// The sessions of a map as one bundle problem in the gauge of the map (§4.3.3): landmarks that
// links join are one point, and a feature that a link joins to a landmark observes it.
class MapBundle {
 public:
  // A link unites two landmarks only where each projects into the other's view within
  // max_error_sigmas. Links of frames that are not there, or weak, do nothing.
  MapBundle(const std::vector<PlacedSession>& sessions, const std::vector<FeatureLink>& links,
            double max_error_sigmas);

  // The first camera and the extent of the first session's path stay: they are the map's gauge.
  // More frames than max_frames are adjusted by windows.
  BundleReport Solve(const BundleOptions& options, size_t max_frames);
  // Solves again with other calibrations where the pictures tell them (RefineIntrinsics), and gives
  // those to the sessions. by_part: of each session; those of one drive have one camera. False:
  // nothing was changed.
  bool SolveIntrinsics(const std::vector<BundleIntrinsics>& by_part, const BundleOptions& options);
  // Writes the solution back into the sessions; their places in the map stay.
  void Apply() const;
  // The landmarks that are one point with others.
  SharedLandmarks FindShared() const;
  size_t num_observations() const { return problem_.observations.size(); }

 private:
  // The parts of the problem that stand for one session.
  struct Part {
    PlacedSession placed;
    SessionBundle bundle;  // in the session's own gauge
    uint32_t first_camera = 0, first_landmark = 0;
  };

  std::vector<uint32_t> AddIntrinsics(const std::vector<BundleIntrinsics>& by_part);
  bool SetCameras(const std::vector<uint32_t>& intrinsics_of_part) const;
  double RootExtent() const;
  void Rescale(double factor);
  const Part* PartOf(const FeatureRef& feature) const;
  std::optional<uint32_t> CameraOf(const FeatureRef& feature) const;
  std::optional<uint32_t> LandmarkOf(const FeatureRef& feature) const;
  std::set<uint32_t>& CamerasOf(uint32_t landmark, const FeatureRef& view);
  void AddPart(const PlacedSession& placed);
  void Join(const FeatureLink& link, double max_error_sigmas);
  double ErrorAcross(const FeatureRef& from, const FeatureRef& to) const;
  void Unite(const FeatureLink& link, uint32_t a, uint32_t b, double max_error_sigmas);
  void AddPoints();
  void AddObservations();
  void AddObservation(uint32_t camera, uint32_t landmark, const Eigen::Vector2d& x_normalized,
                      double sigma);

  std::vector<Part> parts_;
  std::map<SessionId, size_t> part_of_;
  uint32_t num_landmarks_ = 0;                         // of all parts
  UnionFind<uint32_t> united_;                         // landmarks that links join
  std::vector<uint32_t> point_of_;                     // in the problem, by landmark
  std::map<uint32_t, std::set<uint32_t>> cameras_of_;  // of linked landmarks, by root
  std::set<std::pair<uint32_t, FeatureRef>> across_;   // landmark, and a feature that sees it too
  BundleProblem problem_;
};

}  // namespace rovio_sfm
