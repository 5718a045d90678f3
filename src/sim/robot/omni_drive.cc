#include "rovio_sfm/sim/robot/omni_drive.h"

#include <algorithm>
#include <cmath>

#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm::sim {
namespace {

constexpr int64_t kStep_ns = 5'000'000;
constexpr double kStep_s = 5e-3;
constexpr double kTopSpeed_m_per_s = 0.30;  // of speed number 1; number 10 is a tenth of it
constexpr double kTopTurn_rad_per_s = 2.0;
constexpr double kDefaultTurn_rad = Radians(20.0);
constexpr double kTurnPerStep_rad = Radians(11.25);
constexpr double kAtRest_m_per_s = 1e-3;

bool IsStepwiseTurn(int drive) { return drive == 17 || drive == 18; }

double TurnOfSteps(const std::optional<int>& steps) {
  return steps ? kTurnPerStep_rad * (*steps + 1) : kDefaultTurn_rad;
}

double SpeedOf(const BodyRates& rates) {
  return std::hypot(rates.forward_m_per_s, rates.left_m_per_s) +
         0.145 * std::abs(rates.turn_rad_per_s);
}

double Saturate(double value, double bound) { return std::clamp(value, -bound, bound); }

}  // namespace

BodyRates RatesOfDrive(int drive, int speed) {
  const double share = (11 - speed) / 10.0;
  const double v = kTopSpeed_m_per_s * share, d = v * M_SQRT1_2, w = kTopTurn_rad_per_s * share;
  switch (drive) {
    case 1:
      return {v, 0, 0};
    case 2:
      return {-v, 0, 0};
    case 3:
      return {0, v, 0};
    case 4:
      return {0, -v, 0};
    case 5:
    case 17:
      return {0, 0, w};
    case 6:
    case 18:
      return {0, 0, -w};
    case 7:
      return {d, d, 0};
    case 8:
      return {d, -d, 0};
    case 9:
      return {-d, d, 0};
    case 10:
      return {-d, -d, 0};
    default:
      return {};
  }
}

OmniDrive::OmniDrive(const PlanarPose& start, const OmniDriveOptions& options, IsFree is_free)
    : options_(options),
      is_free_(std::move(is_free)),
      rng_(options.seed ^ 0x6472697665ULL),
      slip_(DrawSlip(options.slip, rng_)),
      counter_(options.geometry, options.slip.lost_tick_share, rng_.Fork(1)),
      pose_(start) {
  ROVIO_CHECK(options.slip.IsValid(nullptr));
}

void OmniDrive::AdvanceTo(int64_t time_ns) {
  if (!has_begun_) {
    time_ns_ = time_ns;
    has_begun_ = true;
  }
  while (time_ns_ + kStep_ns <= time_ns) {
    time_ns_ += kStep_ns;
    Step();
  }
}

void OmniDrive::Drive(const DriveCommand& command) {
  command_ = RatesOfDrive(command.drive, command.speed);
  const bool is_forever = command.hold_ns == kHoldForever;
  command_end_ns_ = is_forever ? kHoldForever : time_ns_ + command.hold_ns;
  turn_left_rad_.reset();
  if (IsStepwiseTurn(command.drive) && !is_forever) {
    turn_left_rad_ = TurnOfSteps(command.angle_steps);
    command_end_ns_ = kHoldForever;
  }
}

void OmniDrive::Stop() {
  command_ = {};
  turn_left_rad_.reset();
  command_end_ns_ = time_ns_;
}

void OmniDrive::Step() {
  const bool is_driven = time_ns_ <= command_end_ns_ && (!turn_left_rad_ || *turn_left_rad_ > 0.0);
  Follow(is_driven ? command_ : BodyRates{});
  if (SpeedOf(rates_) < kAtRest_m_per_s) {
    rates_ = {};
    return;
  }
  if (turn_left_rad_) *turn_left_rad_ -= std::abs(rates_.turn_rad_per_s) * kStep_s;
  CountTicks();
  Move();
  Rock();
}

void OmniDrive::Follow(const BodyRates& target) {
  const double share = kStep_s / (options_.lag_s + kStep_s);
  rates_.forward_m_per_s += share * (target.forward_m_per_s - rates_.forward_m_per_s);
  rates_.left_m_per_s += share * (target.left_m_per_s - rates_.left_m_per_s);
  rates_.turn_rad_per_s += share * (target.turn_rad_per_s - rates_.turn_rad_per_s);
}

void OmniDrive::CountTicks() {
  const BodyMotion motion{rates_.forward_m_per_s * kStep_s, rates_.left_m_per_s * kStep_s,
                          rates_.turn_rad_per_s * kStep_s};
  const std::array<int, 3> ticks = counter_.Add(RimTravel(motion, options_.geometry));
  for (size_t wheel = 0; wheel < 3; ++wheel) {
    if (ticks[wheel] == 0) continue;
    ticks_[wheel].ticks = static_cast<uint16_t>(ticks_[wheel].ticks + std::abs(ticks[wheel]));
    ticks_[wheel].direction = ticks[wheel] < 0 ? 0x02 : 0x05;
  }
}

void OmniDrive::Move() {
  const double forward_m = slip_.forward_gain * rates_.forward_m_per_s * kStep_s;
  const double left_m = slip_.side_gain * rates_.left_m_per_s * kStep_s;
  const double walk_rad = options_.slip.heading_walk_rad_per_sqrt_m *
                          std::sqrt(std::hypot(forward_m, left_m)) * rng_.Gaussian();
  const double turn_rad = slip_.turn_gain * rates_.turn_rad_per_s * kStep_s + walk_rad;
  const double heading = pose_.yaw_rad + 0.5 * turn_rad;
  const double c = std::cos(heading), s = std::sin(heading);
  const double x_m = pose_.x_m + c * forward_m - s * left_m;
  const double y_m = pose_.y_m + s * forward_m + c * left_m;
  pose_.yaw_rad += turn_rad;
  if (is_free_ && !is_free_(x_m, y_m)) return;
  pose_.x_m = x_m;
  pose_.y_m = y_m;
}

void OmniDrive::Rock() {
  const double share = kStep_s / options_.rocking_s;
  const double kick = std::sqrt(2.0 * share);
  constexpr double kTilt_rad = Radians(0.5), kHeight_m = 0.002;
  const auto sway = [&](double value, double bound) {
    return Saturate(value * (1.0 - share) + 0.45 * bound * kick * rng_.Gaussian(), bound);
  };
  rocking_ = {sway(rocking_.pitch_rad, kTilt_rad), sway(rocking_.roll_rad, kTilt_rad),
              sway(rocking_.height_m, kHeight_m)};
}

std::array<WheelReading, 3> OmniDrive::TakeTicks() {
  const std::array<WheelReading, 3> taken = ticks_;
  ticks_ = {};
  return taken;
}

}  // namespace rovio_sfm::sim
