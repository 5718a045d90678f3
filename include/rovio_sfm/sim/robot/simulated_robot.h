#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "rovio_sfm/sim/robot/omni_drive.h"
#include "rovio_sfm/sim/robot/robot_backend.h"
#include "rovio_sfm/sim/world/develop_image.h"
#include "rovio_sfm/sim/world/render_image.h"
#include "rovio_sfm/sim/world/world.h"
#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm::sim {

struct SimulatedRobotOptions {
  PlanarPose start;
  double head_position = kHeadUp;
  double exposure = 1.0;        // gain on the world's light
  double exposure_stops = 1.7;  // range of the slow wave of the light
  double exposure_period_s = 90.0;
  double shutter_s = 1.0 / 60.0;
  uint64_t seed = 1;
  Movers movers;  // start with the robot's clock
  RenderOptions render;
  DevelopOptions develop;
  OmniDriveOptions drive;

  bool IsValid(std::string* error) const;
};

// A Rovio in a world: drives, slips, counts ticks, sees. Thread rule: that of RobotBackend.
class SimulatedRobot : public RobotBackend {
 public:
  // The world must outlive the robot. Needs valid options.
  SimulatedRobot(const World& world, const SimulatedRobotOptions& options);

  void AdvanceTo(int64_t time_ns) override;
  NavResponse Drive(const DriveCommand& command) override;
  void Stop() override;
  void MoveHead(HeadPosition target) override;
  void SwitchHeadlight(bool on) override;
  void SwitchInfrared(bool on) override;
  McuReading ReadMcu() override;
  McuReading PeekMcu() const override;
  NavReading ReadNav() const override;
  NavResponse SaveHome() override;
  NavResponse ClearHome() override;
  TruePose ReadTruth() const override;
  std::optional<CapturedImage> Capture(int64_t time_ns, const CameraSettings& settings) override;

 private:
  struct Pose {
    Rigid3 world_from_base;
    Rigid3 world_from_camera;
  };

  McuReading PeekMcuLocked() const REQUIRES(mutex_);
  Pose PoseOf(const OmniDrive& drive) const REQUIRES(mutex_);
  void AdvanceHead(int64_t time_ns) REQUIRES(mutex_);
  bool SeesObstacle() const REQUIRES(mutex_);
  CameraMotion MotionDuring(int64_t open_ns, int64_t close_ns) const EXCLUDES(mutex_);
  const ImageRenderer& RendererFor(int resolution);
  const cv::Mat& LightOf(const CameraMotion& motion, int resolution, double elapsed_s);
  double ElapsedAt(int64_t time_ns) const;  // s since the robot's clock started
  double ExposureAt(double elapsed_s, int brightness) const;

  const World& world_;
  const SimulatedRobotOptions options_;

  // Of the capture thread alone. A robot at rest sees the same light again and again; only noise
  // and exposure change, so the last rendering is kept.
  struct Rendering {
    CameraMotion motion;
    int resolution = -1;
    cv::Mat light;
  };
  std::map<int, std::unique_ptr<ImageRenderer>> renderers_;
  Rendering last_;

  mutable Mutex mutex_;
  OmniDrive drive_ GUARDED_BY(mutex_);
  int64_t time_ns_ GUARDED_BY(mutex_) = 0;
  int64_t start_ns_ GUARDED_BY(mutex_) = -1;
  double head_ GUARDED_BY(mutex_);
  double head_target_ GUARDED_BY(mutex_);
  bool headlight_ GUARDED_BY(mutex_) = false;
  bool infrared_ GUARDED_BY(mutex_) = false;
  bool home_saved_ GUARDED_BY(mutex_) = false;
};

}  // namespace rovio_sfm::sim
