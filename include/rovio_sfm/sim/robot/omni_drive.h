#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>

#include "rovio_sfm/sim/robot/omni_wheels.h"
#include "rovio_sfm/sim/robot/robot_backend.h"
#include "rovio_sfm/sim/robot/robot_body.h"

namespace rovio_sfm::sim {

// What the wheels are told: rates of the body if nothing slipped.
struct BodyRates {
  double forward_m_per_s = 0.0, left_m_per_s = 0.0, turn_rad_per_s = 0.0;
};

// The rates that a nav drive (1-10, 17, 18) asks for at a speed number (1 fastest … 10 slowest).
BodyRates RatesOfDrive(int drive, int speed);

struct OmniDriveOptions {
  OmniGeometry geometry;
  SlipOptions slip;
  double lag_s = 0.08;      // time constant by which the wheels follow a command
  double rocking_s = 0.25;  // time constant of the body's rocking while it moves
  uint64_t seed = 1;
};

// The chassis in motion: commands in, true pose and ticks out. Time is stepped on a grid of 5 ms
// from the start, so that the pose depends on the commands alone, not on how often somebody looks.
// A value: copies run on by themselves and see the same floor.
class OmniDrive {
 public:
  // is_free tells whether the robot's middle may stand at a place (m, world); empty: everywhere.
  using IsFree = std::function<bool(double x_m, double y_m)>;

  OmniDrive(const PlanarPose& start, const OmniDriveOptions& options, IsFree is_free);

  // Never back.
  void AdvanceTo(int64_t time_ns);
  void Drive(const DriveCommand& command);
  void Stop();

  const PlanarPose& pose() const { return pose_; }
  const Rocking& rocking() const { return rocking_; }
  int64_t time_ns() const { return time_ns_; }

  // Ticks and senses since the last call.
  std::array<WheelReading, 3> TakeTicks();

 private:
  void Step();
  void Follow(const BodyRates& target);
  void Move();
  void CountTicks();
  void Rock();

  OmniDriveOptions options_;
  IsFree is_free_;
  Rng rng_;
  Slip slip_;
  TickCounter counter_;
  PlanarPose pose_;
  Rocking rocking_;
  BodyRates rates_;  // of the wheels now
  BodyRates command_;
  int64_t time_ns_ = 0;
  bool has_begun_ = false;  // the first AdvanceTo sets the time
  int64_t command_end_ns_ = 0;
  std::optional<double> turn_left_rad_;  // of a stepwise turn
  std::array<WheelReading, 3> ticks_{};
};

}  // namespace rovio_sfm::sim
