#include "rovio_sfm/sim/robot/simulated_robot.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm::sim {
namespace {

constexpr double kHeadUnitsPerSecond = (kHeadDown - kHeadUp) / 1.1;
constexpr float kBodyRadius_m = 0.16f, kBodyHeight_m = 0.06f;
constexpr float kInfraredReach_m = 0.5f;
constexpr double kNorthStarUnitsPerMeter = 4500.0;
constexpr int64_t kBatteryStep_ns = 60'000'000'000;
// Of compression ratio 0 … 2, at most.
constexpr int kPlainQualities[] = {60, 70, 80}, kRobotQualities[] = {30, 45, 60};
// Of a VGA picture, by ratio: clients take 10 to 50 kB as usual and drop larger ones as broken.
constexpr double kVgaBytes[] = {20'000.0, 35'000.0, 50'000.0};
constexpr double kVgaPixels = 640.0 * 480.0;
constexpr double kLeastBytes = 4096.0;  // below 3.5 kB clients drop a picture too

size_t MaxBytesOf(const cv::Mat& picture, int ratio) {
  const double share = static_cast<double>(picture.total()) / kVgaPixels;
  return static_cast<size_t>(std::max(kVgaBytes[ratio] * share, kLeastBytes));
}

// Rays around the body find what it would run into.
OmniDrive::IsFree FreeSpaceOf(const World& world) {
  return [&world](double x_m, double y_m) {
    const Eigen::Vector3f middle(static_cast<float>(x_m), static_cast<float>(y_m), kBodyHeight_m);
    for (int i = 0; i < 12; ++i) {
      const float angle = static_cast<float>(i * M_PI / 6.0);
      const Eigen::Vector3f direction(std::cos(angle), std::sin(angle), 0.0f);
      if (world.scene().IsBlocked(middle, direction, kBodyRadius_m)) return false;
    }
    return true;
  };
}

bool IsSame(const Rigid3& a, const Rigid3& b) {
  return a.translation == b.translation && a.rotation.coeffs() == b.rotation.coeffs();
}

bool IsSame(const CameraMotion& a, const CameraMotion& b) {
  return IsSame(a.world_from_camera_open, b.world_from_camera_open) &&
         IsSame(a.world_from_camera_close, b.world_from_camera_close);
}

// The samples of a picture depend on where the camera is, not on when it looks.
uint64_t SeedOf(const CameraMotion& motion) {
  uint64_t seed = 0;
  for (const double value : motion.world_from_camera_open.translation) {
    uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    seed = (seed ^ bits) * 0x9e3779b97f4a7c15ULL;
  }
  return seed;
}

OmniDriveOptions DriveOptionsOf(const SimulatedRobotOptions& options) {
  OmniDriveOptions drive = options.drive;
  drive.seed = options.seed;
  return drive;
}

}  // namespace

bool SimulatedRobotOptions::IsValid(std::string* error) const {
  OptionChecker check("robot", error);
  check.Range("head_position", head_position, 60.0, 210.0);
  check.Range("exposure", exposure, 0.01, 100.0);
  check.Range("exposure_stops", exposure_stops, 0.0, 4.0);
  check.Range("exposure_period_s", exposure_period_s, 1.0, 1e6);
  check.Range("shutter_s", shutter_s, 0.0, 0.5);
  check.Nested(render);
  check.Nested(develop);
  check.Nested(drive.slip);
  return check.Passed();
}

SimulatedRobot::SimulatedRobot(const World& world, const SimulatedRobotOptions& options)
    : world_(world),
      options_(options),
      drive_(options.start, DriveOptionsOf(options), FreeSpaceOf(world)),
      head_(options.head_position),
      head_target_(options.head_position) {
  ROVIO_CHECK(options.IsValid(nullptr));
}

void SimulatedRobot::AdvanceTo(int64_t time_ns) {
  const MutexLock lock(mutex_);
  if (start_ns_ < 0) start_ns_ = time_ns_ = time_ns;
  drive_.AdvanceTo(time_ns);
  AdvanceHead(time_ns);
  time_ns_ = std::max(time_ns_, time_ns);
}

void SimulatedRobot::AdvanceHead(int64_t time_ns) {
  const double reach = kHeadUnitsPerSecond * 1e-9 * static_cast<double>(time_ns - time_ns_);
  head_ += std::clamp(head_target_ - head_, -reach, reach);
}

NavResponse SimulatedRobot::Drive(const DriveCommand& command) {
  const MutexLock lock(mutex_);
  drive_.Drive(command);
  return NavResponse::kSuccess;
}

void SimulatedRobot::Stop() {
  const MutexLock lock(mutex_);
  drive_.Stop();
  head_target_ = head_;
}

void SimulatedRobot::MoveHead(HeadPosition target) {
  const MutexLock lock(mutex_);
  head_target_ = target == HeadPosition::kDown     ? kHeadDown
                 : target == HeadPosition::kMiddle ? kHeadMiddle
                                                   : kHeadUp;
}

void SimulatedRobot::SwitchHeadlight(bool on) {
  const MutexLock lock(mutex_);
  headlight_ = on;
}

void SimulatedRobot::SwitchInfrared(bool on) {
  const MutexLock lock(mutex_);
  infrared_ = on;
}

McuReading SimulatedRobot::ReadMcu() {
  const MutexLock lock(mutex_);
  McuReading reading = PeekMcuLocked();
  const std::array<WheelReading, 3> ticks = drive_.TakeTicks();
  reading.left = ticks[kLeftWheel];
  reading.right = ticks[kRightWheel];
  reading.rear = ticks[kRearWheel];
  return reading;
}

McuReading SimulatedRobot::PeekMcu() const {
  const MutexLock lock(mutex_);
  return PeekMcuLocked();
}

McuReading SimulatedRobot::PeekMcuLocked() const {
  McuReading reading;
  reading.head_position = static_cast<uint8_t>(std::lround(head_));
  const int64_t used = (time_ns_ - std::max<int64_t>(start_ns_, 0)) / kBatteryStep_ns;
  reading.battery = static_cast<uint8_t>(126 - std::min<int64_t>(used, 16));
  reading.headlight = headlight_;
  reading.infrared = infrared_;
  reading.obstacle = infrared_ && SeesObstacle();
  return reading;
}

bool SimulatedRobot::SeesObstacle() const {
  const PlanarPose& pose = drive_.pose();
  const Eigen::Vector3f middle(static_cast<float>(pose.x_m), static_cast<float>(pose.y_m),
                               kBodyHeight_m);
  const float yaw = static_cast<float>(pose.yaw_rad);
  return world_.scene().IsBlocked(middle, {std::cos(yaw), std::sin(yaw), 0.0f}, kInfraredReach_m);
}

NavReading SimulatedRobot::ReadNav() const {
  const MutexLock lock(mutex_);
  const PlanarPose& pose = drive_.pose();
  NavReading reading;
  reading.x = static_cast<int>(std::lround(kNorthStarUnitsPerMeter * pose.x_m)) % 32767;
  reading.y = static_cast<int>(std::lround(kNorthStarUnitsPerMeter * pose.y_m)) % 32767;
  reading.theta_rad = std::remainder(pose.yaw_rad, 2.0 * M_PI);
  reading.signal_strength = 18000;
  reading.home_saved = home_saved_;
  return reading;
}

NavResponse SimulatedRobot::SaveHome() {
  const MutexLock lock(mutex_);
  home_saved_ = true;
  return NavResponse::kSuccess;
}

NavResponse SimulatedRobot::ClearHome() {
  const MutexLock lock(mutex_);
  home_saved_ = false;
  return NavResponse::kSuccess;
}

SimulatedRobot::Pose SimulatedRobot::PoseOf(const OmniDrive& drive) const {
  const PlanarPose& at = drive.pose();
  const Rigid3 world_from_base = WorldFromBase(at.x_m, at.y_m, at.yaw_rad, drive.rocking());
  return {world_from_base, world_from_base * BaseFromCamera(head_)};
}

TruePose SimulatedRobot::ReadTruth() const {
  const MutexLock lock(mutex_);
  const Pose pose = PoseOf(drive_);
  return {time_ns_, pose.world_from_base, pose.world_from_camera};
}

// Runs a copy of the drive ahead; the robot itself stays where it is.
CameraMotion SimulatedRobot::MotionDuring(int64_t open_ns, int64_t close_ns) const {
  const MutexLock lock(mutex_);
  OmniDrive ahead = drive_;
  ahead.AdvanceTo(open_ns);
  const Rigid3 world_from_camera_open = PoseOf(ahead).world_from_camera;
  ahead.AdvanceTo(close_ns);
  return {world_from_camera_open, PoseOf(ahead).world_from_camera};
}

const ImageRenderer& SimulatedRobot::RendererFor(int resolution) {
  std::unique_ptr<ImageRenderer>& renderer = renderers_[resolution];
  if (!renderer) {
    const ImageSize size = SizeOfResolution(resolution);
    const Camera camera = ScaleCamera(RovioCamera(), size.width, size.height);
    renderer = std::make_unique<ImageRenderer>(world_, camera, options_.render);
  }
  return *renderer;
}

const cv::Mat& SimulatedRobot::LightOf(const CameraMotion& motion, int resolution,
                                       double elapsed_s) {
  const bool is_same = last_.resolution == resolution && IsSame(last_.motion, motion);
  if (!is_same || !options_.movers.empty()) {
    last_ = {motion, resolution,
             RendererFor(resolution).Render(motion, SeedOf(motion), options_.movers.At(elapsed_s))};
  }
  return last_.light;
}

double SimulatedRobot::ElapsedAt(int64_t time_ns) const {
  const MutexLock lock(mutex_);
  return 1e-9 * static_cast<double>(time_ns - std::max<int64_t>(start_ns_, 0));
}

double SimulatedRobot::ExposureAt(double elapsed_s, int brightness) const {
  const double wave = std::sin(2.0 * M_PI * elapsed_s / options_.exposure_period_s);
  const double stops = 0.5 * options_.exposure_stops * wave + 0.25 * (brightness - 6);
  return options_.exposure * std::exp2(stops);
}

std::optional<CapturedImage> SimulatedRobot::Capture(int64_t time_ns,
                                                     const CameraSettings& settings) {
  const int64_t shutter_ns = static_cast<int64_t>(1e9 * options_.shutter_s);
  const CameraMotion motion = MotionDuring(time_ns, time_ns + shutter_ns);
  const uint64_t seed = options_.seed * 0x9e3779b97f4a7c15ULL ^ static_cast<uint64_t>(time_ns);
  const double elapsed_s = ElapsedAt(time_ns);
  const cv::Mat& light = LightOf(motion, settings.resolution, elapsed_s);
  DevelopOptions develop = options_.develop;
  const int ratio = std::clamp(settings.compression_ratio, 0, 2);
  develop.jpeg_quality =
      (develop.sensor == Sensor::kBayer ? kRobotQualities : kPlainQualities)[ratio];
  develop.max_bytes = std::min(develop.max_bytes, MaxBytesOf(light, ratio));
  const double exposure = ExposureAt(elapsed_s, settings.brightness);
  return CapturedImage{time_ns, EncodeJpeg(DevelopImage(light, exposure, develop, seed), develop)};
}

}  // namespace rovio_sfm::sim
