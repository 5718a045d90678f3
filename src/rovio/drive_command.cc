#include "rovio_sfm/rovio/drive_command.h"

#include <cmath>

namespace rovio_sfm {
namespace {

constexpr int kMaxStopsInVain = 10;
constexpr int64_t kWakingNs = 200'000'000;  // in which what waited is heard

bool FallsSteadily(const std::array<double, 10>& table) {
  for (size_t i = 0; i + 1 < table.size(); ++i) {
    if (!(table[i] > table[i + 1])) return false;
  }
  return true;
}

// The number whose value is next to the wish.
int NearestNumber(const std::array<double, 10>& table, double wish) {
  size_t best = 0;
  for (size_t i = 1; i < table.size(); ++i) {
    if (std::abs(table[i] - wish) < std::abs(table[best] - wish)) best = i;
  }
  return static_cast<int>(best) + 1;
}

// The direction of eight whose sector of 45 deg holds (forward, left).
DriveCode DirectionOf(double forward, double left) {
  constexpr std::array<DriveCode, 8> kDirections = {
      DriveCode::kForward,  DriveCode::kForwardLeft,   DriveCode::kLeft,  DriveCode::kBackwardLeft,
      DriveCode::kBackward, DriveCode::kBackwardRight, DriveCode::kRight, DriveCode::kForwardRight};
  const int sector = static_cast<int>(std::lround(std::atan2(left, forward) / (M_PI / 4.0)));
  return kDirections[static_cast<size_t>((sector + 8) % 8)];
}

}  // namespace

void DriveOptions::DescribeOptions(OptionTable& table) {
  constexpr const char* kFalls = "numbers that fall from the first to the last";
  table.AddSeconds("cmd_vel_timeout_s", max_command_age_ns, 0.02, 5.0, "silence, then it stops");
  table.AddSeconds("repeat_period_s", repeat_period_ns, 0.02, 0.2, "a robot holds a command 0.2 s");
  table.AddRule("cmd_vel_timeout_s", max_command_age_ns >= repeat_period_ns,
                "at least repeat_period_s");
  table.AddNumbers("speed_m_per_s", speed_m_per_s, 0.001, 100.0, "of number 1 to 10");
  table.AddRule("speed_m_per_s", FallsSteadily(speed_m_per_s), kFalls);
  table.AddNumbers("turn_rad_per_s", turn_rad_per_s, 0.001, 100.0, "of number 1 to 10");
  table.AddRule("turn_rad_per_s", FallsSteadily(turn_rad_per_s), kFalls);
  table.AddNumber("min_speed_m_per_s", min_speed_m_per_s, 0.0, 100.0, "below it counts as zero");
  table.AddNumber("min_turn_rad_per_s", min_turn_rad_per_s, 0.0, 100.0, "below it counts as zero");
  table.AddNumber("turn_radius_m", turn_radius_m, 0.001, 10.0, "weighs a turn against a move");
}

DriveCommand ChooseDrive(const BaseVelocity& velocity, const DriveOptions& options) {
  const double speed = std::hypot(velocity.forward_m_per_s, velocity.left_m_per_s);
  const double turn = std::abs(velocity.yaw_rad_per_s);
  if (!std::isfinite(speed) || !std::isfinite(turn)) return {};
  const bool moves = speed >= options.min_speed_m_per_s;
  const bool turns = turn >= options.min_turn_rad_per_s;
  if (!moves && !turns) return {};
  if (!moves || (turns && turn * options.turn_radius_m > speed)) {
    const DriveCode code =
        velocity.yaw_rad_per_s > 0.0 ? DriveCode::kRotateLeft : DriveCode::kRotateRight;
    return {code, NearestNumber(options.turn_rad_per_s, turn)};
  }
  return {DirectionOf(velocity.forward_m_per_s, velocity.left_m_per_s),
          NearestNumber(options.speed_m_per_s, speed)};
}

void DriveScheduler::SetWish(const BaseVelocity& velocity, int64_t now_ns) {
  const DriveCommand wish = ChooseDrive(velocity, options_);
  if (wish.code != DriveCode::kStop && now_ns < deaf_until_ns_) return;
  wish_ = wish;
  wish_ns_ = now_ns;
}

void DriveScheduler::NoteAwake(int64_t now_ns) {
  if (awake_ns_ && now_ns - *awake_ns_ > options_.max_command_age_ns) {
    deaf_until_ns_ = now_ns + kWakingNs;
  }
  awake_ns_ = now_ns;
}

std::optional<DriveCommand> DriveScheduler::Next(int64_t now_ns) {
  if (now_ns - wish_ns_ > options_.max_command_age_ns) wish_ = {};
  if (wish_.code == DriveCode::kStop) {
    if (!is_moving_) return std::nullopt;
    if (last_sent_.code == DriveCode::kStop && now_ns - last_sent_ns_ < options_.repeat_period_ns) {
      return std::nullopt;
    }
  } else if (now_ns - last_sent_ns_ < options_.repeat_period_ns) {
    return std::nullopt;
  }
  last_sent_ns_ = now_ns;
  last_sent_ = wish_;
  if (wish_.code != DriveCode::kStop) is_moving_ = true;
  return wish_;
}

void DriveScheduler::MarkSent(const DriveCommand& command, bool has_arrived) {
  const bool is_stop = command.code == DriveCode::kStop;
  if (!has_arrived) wish_ = {};
  num_stops_in_vain_ = is_stop && !has_arrived ? num_stops_in_vain_ + 1 : 0;
  const bool is_over = has_arrived || num_stops_in_vain_ >= kMaxStopsInVain;
  if (is_stop && wish_.code == DriveCode::kStop && is_over) is_moving_ = false;
}

}  // namespace rovio_sfm
