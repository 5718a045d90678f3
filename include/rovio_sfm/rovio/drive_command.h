#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "rovio_sfm/rovio/drive_code.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// A wished velocity of the base: x forward, y left, yaw to the left.
struct BaseVelocity {
  double forward_m_per_s = 0.0;
  double left_m_per_s = 0.0;
  double yaw_rad_per_s = 0.0;
};

// One manual drive command of the robot. kStop has no speed.
struct DriveCommand {
  DriveCode code = DriveCode::kStop;
  int speed = 0;  // 1 fastest … 10 slowest

  bool operator==(const DriveCommand& other) const {
    return code == other.code && speed == other.speed;
  }
};

// What the robot's speed numbers mean; no source says, so both tables are to be measured.
struct DriveOptions {
  std::array<double, 10> speed_m_per_s = {0.30, 0.27, 0.24, 0.21, 0.18,
                                          0.15, 0.12, 0.09, 0.06, 0.03};
  std::array<double, 10> turn_rad_per_s = {2.0, 1.8, 1.6, 1.4, 1.2, 1.0, 0.8, 0.6, 0.4, 0.2};
  double min_speed_m_per_s = 0.01;
  double min_turn_rad_per_s = 0.05;
  double turn_radius_m = 0.145;
  int64_t repeat_period_ns = 100000000;
  int64_t max_command_age_ns = 500000000;

  void DescribeOptions(OptionTable& table);
};

// The robot's nearest motion: it moves in eight directions or turns, never both at once; the
// greater of the two wins, with the speed number next to the wished speed. Not finite: stop.
DriveCommand ChooseDrive(const BaseVelocity& velocity, const DriveOptions& options);

// Says when to send which command. Commands are repeated while the wish is young, stopped when it
// ceases, and never sent more often than the period except to stop. Times in ns, never falling.
class DriveScheduler {
 public:
  explicit DriveScheduler(const DriveOptions& options) : options_(options) {}

  // A motion that may have waited while this process slept (suspended, stopped) is not taken; a
  // stop always is.
  void SetWish(const BaseVelocity& velocity, int64_t now_ns);

  // Tells that the process runs; call often. After a silence longer than a command may be old it
  // was asleep: what is heard within a moment was said before.
  void NoteAwake(int64_t now_ns);

  // The command to send now, if any. A stop is given until MarkSent confirms it.
  std::optional<DriveCommand> Next(int64_t now_ns);

  // Tells that a command reached the robot, or not. After a failure the wish is forgotten: the
  // robot moves again only on a new one.
  void MarkSent(const DriveCommand& command, bool has_arrived);

  bool IsMoving() const { return is_moving_; }

 private:
  const DriveOptions options_;
  DriveCommand wish_;
  int64_t wish_ns_ = 0;
  std::optional<int64_t> awake_ns_;
  int64_t deaf_until_ns_ = INT64_MIN;
  int64_t last_sent_ns_ = INT64_MIN / 2;
  DriveCommand last_sent_;
  bool is_moving_ = false;  // a motion was sent since the last stop that arrived
  int num_stops_in_vain_ = 0;
};

}  // namespace rovio_sfm
