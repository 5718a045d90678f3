#include "rovio_sfm/report/measure_odometry_delay.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rovio_sfm/util/log.h"

namespace rovio_sfm {
namespace {

constexpr double kDelayS = 0.08;
constexpr int64_t kStepNs = 100'000'000;
constexpr uint32_t kNumFrames = 150;

double Heading(double time_s) { return 0.8 * std::sin(1.3 * time_s); }

int64_t Stamp(uint32_t frame) { return 1600000000000000000 + frame * kStepNs; }

double DelayedYaw(uint32_t frame) { return Heading(0.1 * frame - kDelayS); }

Rigid3 CamFromMap(uint32_t frame, const Rigid3& base_from_camera) {
  const Eigen::AngleAxisd heading(Heading(0.1 * frame), Eigen::Vector3d::UnitZ());
  const Rigid3 map_from_base{Eigen::Quaterniond(heading), {0.05 * frame, 0.0, 0.0}};
  return Inverse(map_from_base * base_from_camera);
}

const Rigid3 kBaseFromCamera{Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5), {0.1, 0.0, 0.2}};

Session TurningSession(bool with_odometry) {
  Session session({1}, {"rovio1", Stamp(0), 1}, {500, 500, 320, 240, 0, 0, 0, 0, 0, 640, 480});
  for (uint32_t i = 0; i < kNumFrames; ++i) {
    Keyframe frame;
    frame.stamp_ns = Stamp(i);
    frame.cam_from_session = CamFromMap(i, kBaseFromCamera);
    frame.base_from_camera = kBaseFromCamera;
    if (with_odometry) frame.odometry = OdometrySample{0.0, 0.0, DelayedYaw(i), {}};
    session.AddKeyframe(i, std::move(frame));
  }
  return session;
}

LevelMap MapOf(const Session& session) {
  LevelMap map;
  map.sessions.push_back(session.Snapshot());
  return map;
}

TEST(MeasureOdometryDelay, FindsItInASessionsKeyframes) {
  const auto delay = MeasureOdometryDelay(TurningSession(true));
  ASSERT_TRUE(delay.has_value());
  EXPECT_NEAR(delay->delay_s, kDelayS, 0.01);
}

TEST(MeasureOdometryDelay, KnowsNothingWithoutOdometry) {
  EXPECT_FALSE(MeasureOdometryDelay(TurningSession(false)).has_value());
}

TEST(UpdateOdometryDelay, WarnsOfADelayThatMattersAndKeepsIt) {
  std::string logged;
  SetLogSink([&](LogLevel level, const std::string& message) {
    if (level == LogLevel::kWarning) logged = message;
  });
  Session session = TurningSession(true);
  UpdateOdometryDelay(&session);
  SetLogSink([](LogLevel, const std::string&) {});
  EXPECT_NE(logged.find("session 1: odometry is stamped 0.0"), std::string::npos) << logged;
  ASSERT_TRUE(session.Snapshot().odometry_delay.has_value());
  EXPECT_NEAR(session.Snapshot().odometry_delay->delay_s, kDelayS, 0.01);
}

TEST(MeasureOdometryDelay, FindsItInAMapByTheStampsOfItsImages) {
  YawByStamp yaws;
  for (uint32_t i = 0; i < kNumFrames; ++i) yaws[Stamp(i)] = DelayedYaw(i);
  const LevelMap map = MapOf(TurningSession(false));
  DriveId drive = map.sessions[0].drive;
  const auto delay = MeasureOdometryDelay(map, {{drive, yaws}});
  ASSERT_TRUE(delay.has_value());
  EXPECT_NEAR(delay->delay_s, kDelayS, 0.01);
  ++drive.nonce;
  EXPECT_FALSE(MeasureOdometryDelay(map, {{drive, yaws}}).has_value());
}

}  // namespace
}  // namespace rovio_sfm
