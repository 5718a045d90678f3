#include "synthetic/synthetic_drive.h"

#include <algorithm>
#include <cmath>

namespace rovio_sfm {
namespace {

constexpr TrackId kBlindTracks = 1'000'000;
constexpr TrackId kTracksAfterCut = 2'000'000;
constexpr uint32_t kDescriptorLength = 128;

bool IsKeyframe(const SyntheticDriveOptions& options, uint32_t cam) {
  return cam % static_cast<uint32_t>(options.light_frames + 1) == 0;
}

TrackId TrackOf(const SyntheticDriveOptions& options, uint32_t cam, uint32_t point) {
  const auto num_points = static_cast<uint32_t>(options.world.num_points);
  TrackId track = point + 1;
  if (options.track_length > 0) {
    const auto length = static_cast<uint32_t>(options.track_length);
    track += num_points * ((cam + point % length) / length);
  }
  if (options.cut && cam >= *options.cut) track += kTracksAfterCut;
  if (options.blind.count(cam) == 1) track = kBlindTracks + cam * num_points + point;
  return track;
}

void AppendDescriptor(uint32_t point, std::vector<uint8_t>* data) {
  Rng rng(point + 77);
  for (uint32_t i = 0; i < kDescriptorLength; ++i) {
    data->push_back(static_cast<uint8_t>(rng.UniformInt(80)));
  }
}

std::shared_ptr<const FrameFeatures> MakeDriveFeatures(const SyntheticWorld& world, uint32_t cam,
                                                       bool is_keyframe) {
  auto features = std::make_shared<FrameFeatures>(MakeFeatures(world, cam));
  if (!is_keyframe) return features;
  features->descriptors = {DescriptorType::kSift, DescriptorMetric::kL2, kDescriptorLength, {}};
  for (const SyntheticView& view : world.views[cam]) {
    AppendDescriptor(view.point, &features->descriptors.data);
  }
  return features;
}

PairMatches MakePair(const SyntheticWorld& world, uint32_t other, uint32_t cam) {
  PairMatches pair;
  pair.other_index = other;
  pair.cam_from_other = world.cams_from_map[cam] * Inverse(world.cams_from_map[other]);
  const double baseline = pair.cam_from_other.translation.norm();
  pair.verdict = baseline > 0.0 ? PairVerdict::kGeneral : PairVerdict::kRotation;
  if (baseline > 0.0) pair.cam_from_other.translation /= baseline;
  pair.inliers = TrueMatches(world, other, cam);
  return pair;
}

// The base looks along the camera's axis, 0.2 m below and 0.1 m behind it.
Rigid3 BaseFromCamera() { return {Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5), {0.1, 0.0, 0.2}}; }

OdometrySample MakeOdometry(const SyntheticWorld& world, uint32_t cam, double metres_per_unit,
                            double gain) {
  Rigid3 first_from_cam = world.cams_from_map[0] * Inverse(world.cams_from_map[cam]);
  first_from_cam.translation *= metres_per_unit;
  const Rigid3 odom_from_base = BaseFromCamera() * first_from_cam * Inverse(BaseFromCamera());
  const Eigen::Vector3d forward = odom_from_base.rotation * Eigen::Vector3d::UnitX();
  return {gain * odom_from_base.translation.x(),
          gain * odom_from_base.translation.y(),
          std::atan2(forward.y(), forward.x()),
          {}};
}

void AddLinks(const SyntheticDriveOptions& options, const SyntheticWorld& world, uint32_t cam,
              uint32_t last_keyframe, FrameEvent* event) {
  const bool after_blind = options.with_late_links && options.blind.count(last_keyframe) == 1;
  if (cam == 0 || !(options.with_links || after_blind)) return;
  for (const SyntheticView& view : world.views[cam]) {
    const TrackId before = TrackOf(options, last_keyframe, view.point);
    const TrackId now = TrackOf(options, cam, view.point);
    if (before != now) event->links.push_back({before, now});
  }
}

FrameEvent MakeEvent(const SyntheticDriveOptions& options, const SyntheticWorld& world,
                     uint32_t cam) {
  const bool is_keyframe = IsKeyframe(options, cam);
  FrameEvent event;
  event.id = {{"rovio", 1000, static_cast<uint32_t>(options.world.seed)}, cam};
  event.kind = is_keyframe ? FrameKind::kKeyframe : FrameKind::kLight;
  event.stamp_ns = 1000 + cam * 100'000'000LL;
  event.image_name = std::to_string(cam) + ".jpg";
  event.camera = world.camera;
  event.features = MakeDriveFeatures(world, cam, is_keyframe);
  for (const SyntheticView& view : world.views[cam]) {
    event.tracks.push_back(TrackOf(options, cam, view.point));
  }
  if (options.metres_per_unit) {
    event.odometry = MakeOdometry(world, cam, *options.metres_per_unit, options.odometry_gain);
    event.base_from_camera = BaseFromCamera();
  }
  if (!is_keyframe || cam == 0) return event;
  const uint32_t last_keyframe = cam - static_cast<uint32_t>(options.light_frames) - 1;
  if (options.cut != cam) event.pairs.push_back(MakePair(world, last_keyframe, cam));
  AddLinks(options, world, cam, last_keyframe, &event);
  return event;
}

template <typename Value>
void Append(const Value& value, std::string* bytes) {
  bytes->append(reinterpret_cast<const char*>(&value), sizeof(Value));
}

void AppendVector(const Eigen::VectorXd& vector, std::string* bytes) {
  for (const double value : vector) Append(value, bytes);
}

}  // namespace

SyntheticOptions SyntheticDriveOptions::DefaultWorld() {
  SyntheticOptions world;
  world.motion = SyntheticMotion::kCircle;
  world.num_points = 250;
  world.num_cams = 16;
  world.step = 0.3;
  return world;
}

SyntheticDrive MakeSyntheticDrive(const SyntheticDriveOptions& options) {
  SyntheticDrive drive;
  drive.world = MakeSyntheticWorld(options.world);
  for (uint32_t cam = 0; cam < drive.world.views.size(); ++cam) {
    drive.events.push_back(MakeEvent(options, drive.world, cam));
  }
  return drive;
}

std::optional<TrajectoryError> MeasureTrajectory(const SessionSnapshot& session,
                                                 const SyntheticWorld& world) {
  std::vector<Rigid3> poses, truth;
  std::vector<Eigen::Vector3d> centers, true_centers;
  for (const auto& block : session.frames) {
    for (const FrameSnapshot& frame : *block) {
      if (frame.weak) continue;
      poses.push_back(frame.cam_from_session);
      truth.push_back(world.cams_from_map[frame.index]);
      centers.push_back(OriginInA(poses.back()));
      true_centers.push_back(OriginInA(truth.back()));
    }
  }
  const auto world_from_session = AlignPoints(centers, true_centers);
  if (!world_from_session) return std::nullopt;
  TrajectoryError error;
  error.num_frames = poses.size();
  for (size_t i = 0; i < poses.size(); ++i) {
    const Rigid3 pose = TransformCamera(*world_from_session, poses[i]);
    error.max_distance = std::max(error.max_distance, (OriginInA(pose) - true_centers[i]).norm());
    error.max_rotation_rad = std::max(error.max_rotation_rad,
                                      RotationAngle(pose.rotation * truth[i].rotation.conjugate()));
  }
  return error;
}

std::string BytesOf(const MapSnapshot& snapshot) {
  std::string bytes;
  for (const SessionSnapshot& session : snapshot.sessions) {
    Append(session.id.value, &bytes);
    Append(session.state, &bytes);
    if (session.scale) Append(session.scale->metres_per_unit, &bytes);
    for (const auto& block : session.frames) {
      for (const FrameSnapshot& frame : *block) {
        Append(frame.index, &bytes);
        Append(frame.weak, &bytes);
        Append(frame.num_observations, &bytes);
        AppendVector(frame.cam_from_session.translation, &bytes);
        AppendVector(frame.cam_from_session.rotation.coeffs(), &bytes);
      }
    }
    for (const auto& block : session.landmarks) {
      for (const LandmarkSnapshot& landmark : *block) {
        Append(landmark.id, &bytes);
        Append(landmark.num_views, &bytes);
        AppendVector(landmark.position, &bytes);
      }
    }
  }
  return bytes;
}

}  // namespace rovio_sfm
