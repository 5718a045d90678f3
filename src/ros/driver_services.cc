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

// The present settings with those of the request that are not KEEP.
CameraSettings Merge(const SetCamera::Request& request, CameraSettings settings) {
  const auto take = [](int8_t wish, int* value) {
    if (wish != SetCamera::Request::KEEP) *value = wish;
  };
  take(request.resolution, &settings.resolution);
  take(request.compression, &settings.compression);
  take(request.frame_rate, &settings.frame_rate);
  take(request.brightness, &settings.brightness);
  return settings;
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
    response.status = MakeStatus(Status::INVALID_ARGUMENT, "position must be 0, 1 or 2");
    return true;
  }
  const RobotOutcome outcome = client_.MoveHead(static_cast<HeadPosition>(request.position));
  response.status = ToStatus(outcome, "the head moves");
  return true;
}

bool DriverServices::SetCamera(SetCamera::Request& request, SetCamera::Response& response) {
  if (request.headlight < rovio_sfm::SetCamera::Request::KEEP || request.headlight > 1) {
    response.status = MakeStatus(Status::INVALID_ARGUMENT, "headlight must be -1, 0 or 1");
    return true;
  }
  response.status = ChangeSettings(request);
  if (response.status.code != Status::OK || request.headlight < 0) return true;
  const RobotOutcome outcome = client_.SetHeadlight(request.headlight == 1);
  response.status = ToStatus(outcome, "done");
  return true;
}

Status DriverServices::ChangeSettings(const rovio_sfm::SetCamera::Request& request) {
  const RobotReply<RobotReport> before = client_.GetReport();
  if (!before.value) return ToStatus(before.outcome, "");
  const CameraSettings wanted = Merge(request, before.value->camera);
  if (wanted == before.value->camera) return MakeStatus(Status::OK, "nothing to change");
  std::string error;
  if (!IsValid(wanted, &error)) return MakeStatus(Status::INVALID_ARGUMENT, error);
  const RobotOutcome outcome = client_.RequestSettings(wanted, before.value->camera);
  if (!outcome.IsOk()) return ToStatus(outcome, "");
  const bool has_obeyed = motion_->WaitForReport(
      kReadBackPatienceS, [&wanted](const RobotReport& report) { return report.camera == wanted; });
  if (has_obeyed) return MakeStatus(Status::OK, "the robot has " + Describe(wanted));
  return MakeStatus(Status::FAILED_PRECONDITION,
                    "the robot answered but did not change (a login may be too low)");
}

bool DriverServices::Dock(Dock::Request& request, Dock::Response& response) {
  const RobotOutcome outcome = request.cancel ? client_.EndAutonomy() : client_.Dock();
  response.status = ToStatus(outcome, request.cancel ? "ended" : "the robot drives to its dock");
  return true;
}

}  // namespace rovio_sfm
