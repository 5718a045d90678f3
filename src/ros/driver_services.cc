#include "rovio_sfm/ros/driver_services.h"

#include "rovio_sfm/ros/topics.h"
#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

constexpr double kReadBackPatienceS = 6.0;

Status MakeStatus(uint8_t code, const std::string& message) {
  Status status;
  status.code = code;
  status.message = message;
  return status;
}

Status ToStatus(const RobotOutcome& outcome, const std::string& success) {
  if (outcome.IsOk()) return MakeStatus(Status::OK, success);
  const bool is_refused = outcome.fault == RobotFault::kRefused;
  return MakeStatus(is_refused ? Status::FAILED_PRECONDITION : Status::INTERNAL,
                    "the robot did not do it: " + outcome.message);
}

// The settings of the request that are not KEEP.
SomeSettings WishesOf(const SetCamera::Request& request) {
  const auto wish_of = [](int8_t wish) {
    return wish == SetCamera::Request::KEEP ? std::nullopt : std::optional<int>(wish);
  };
  SomeSettings wishes;
  wishes.resolution = wish_of(request.resolution);
  wishes.compression = wish_of(request.compression);
  wishes.frame_rate = wish_of(request.frame_rate);
  wishes.brightness = wish_of(request.brightness);
  return wishes;
}

bool AreValid(const SomeSettings& wishes, std::string* error) {
  CameraSettings all;
  all.resolution = wishes.resolution.value_or(all.resolution);
  all.compression = wishes.compression.value_or(all.compression);
  all.frame_rate = wishes.frame_rate.value_or(all.frame_rate);
  all.brightness = wishes.brightness.value_or(all.brightness);
  return IsValid(all, error);
}

}  // namespace

DriverServices::DriverServices(const ros::NodeHandle& handle, const DriverOptions& options,
                               const Credentials& credentials, DriverMotion* motion)
    : motion_(motion),
      transport_(options.http, credentials),
      client_(&transport_),
      handle_(handle),
      spinner_(1, &queue_) {
  handle_.setCallbackQueue(&queue_);
  head_server_ = handle_.advertiseService(topics::kSetHead, &DriverServices::SetHead, this);
  camera_server_ = handle_.advertiseService(topics::kSetCamera, &DriverServices::SetCamera, this);
  dock_server_ = handle_.advertiseService(topics::kDock, &DriverServices::Dock, this);
  spinner_.start();
}

DriverServices::~DriverServices() {
  transport_.Cancel();
  spinner_.stop();
}

bool DriverServices::SetHead(SetHead::Request& request, SetHead::Response& response) {
  if (request.position > rovio_sfm::SetHead::Request::UP) {
    response.status =
        MakeStatus(Status::INVALID_ARGUMENT, "position = " + std::to_string(request.position) +
                                                 ": expected 0 (down), 1 (middle) or 2 (up)");
    return true;
  }
  const RobotOutcome outcome = client_.MoveHead(static_cast<HeadPosition>(request.position));
  response.status = ToStatus(outcome, "the head moves");
  return true;
}

bool DriverServices::SetCamera(SetCamera::Request& request, SetCamera::Response& response) {
  if (request.headlight < rovio_sfm::SetCamera::Request::KEEP || request.headlight > 1) {
    response.status =
        MakeStatus(Status::INVALID_ARGUMENT, "headlight = " + std::to_string(request.headlight) +
                                                 ": expected 0, 1 or -1 (as it is)");
    return true;
  }
  response.status = ChangeSettings(request);
  if (response.status.code != Status::OK || request.headlight < 0) return true;
  const RobotOutcome outcome = client_.SetHeadlight(request.headlight == 1);
  response.status = ToStatus(outcome, "done");
  return true;
}

Status DriverServices::ChangeSettings(const rovio_sfm::SetCamera::Request& request) {
  const SomeSettings wanted = WishesOf(request);
  std::string error;
  if (!AreValid(wanted, &error)) return MakeStatus(Status::INVALID_ARGUMENT, error);
  const RobotReply<RobotReport> before = client_.GetReport();
  if (!before.value) return ToStatus(before.outcome, "");
  motion_->NoteOwnSettings();
  const RobotOutcome outcome = client_.RequestSettings(wanted, before.value->camera);
  if (!outcome.IsOk()) return ToStatus(outcome, "");
  SomeSettings present;
  const bool has_obeyed =
      motion_->WaitForReport(kReadBackPatienceS, [&](const RobotReport& report) {
        present = report.camera;
        return AreAgreed(report.camera, wanted);
      });
  if (has_obeyed) return MakeStatus(Status::OK, "the robot has " + Describe(present));
  return MakeStatus(Status::FAILED_PRECONDITION,
                    "the robot answered but did not change (a login may be too low)");
}

bool DriverServices::Dock(Dock::Request& request, Dock::Response& response) {
  motion_->NoteOwnMotion();
  const RobotOutcome outcome = request.cancel ? client_.EndAutonomy() : client_.Dock();
  response.status = ToStatus(outcome, request.cancel ? "ended" : "the robot drives to its dock");
  return true;
}

}  // namespace rovio_sfm
