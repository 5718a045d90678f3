// The services of PlaceRecognitionNode; see place_recognition_node.h.
#include <rovio_sfm/ListSessions.h>

#include "rovio_sfm/features/decode_image.h"
#include "rovio_sfm/frontend/prepare_image.h"
#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/place_match_message.h"
#include "rovio_sfm/ros/place_recognition_node.h"
#include "rovio_sfm/ros/status.h"
#include "rovio_sfm/ros/topics.h"
#include "rovio_sfm/util/count_text.h"

namespace rovio_sfm {
namespace {

constexpr char kDropped[] = "the call was refused: too many wait already, or the node ends";

}  // namespace

void PlaceRecognitionNode::AdvertiseServices() {
  ros::NodeHandle node(node_);
  node.setCallbackQueue(&service_queue_);
  services_ = {
      node.advertiseService(topics::kFindOverlaps, &PlaceRecognitionNode::FindOverlaps, this),
      node.advertiseService(topics::kQueryImage, &PlaceRecognitionNode::QueryImage, this),
  };
}

// The session as mapping knows it; else status says why not.
std::optional<SessionSummary> PlaceRecognitionNode::FindSession(uint32_t number, Status* status) {
  rovio_sfm::ListSessions sessions;
  if (!mapping_sessions_.call(sessions)) {
    *status = FailedPrecondition("mapping does not answer " + mapping_sessions_.getService());
    return std::nullopt;
  }
  for (const SessionSummary& session : sessions.response.sessions) {
    if (session.session == number) return session;
  }
  *status = NotFound("mapping knows no session " + std::to_string(number));
  return std::nullopt;
}

bool PlaceRecognitionNode::FindOverlaps(FindOverlapsRequest& request,
                                        FindOverlapsResponse& response) {
  const auto a = FindSession(request.session_a, &response.status);
  if (!a) return true;
  const auto b = FindSession(request.session_b, &response.status);
  if (!b) return true;
  std::vector<PlaceMatch> matches;
  size_t num_compared = 0;
  const bool has_run = RunAndWait(
      [&] {
        matches = Overlaps(*a, *b, &num_compared);
        if (request.publish) Publish(matches, 0);
      },
      kCallLane, &worker_);
  for (const PlaceMatch& match : matches) response.matches.push_back(ToMessage(match, 0));
  response.status =
      has_run ? Ok(CountText(num_compared, "keyframe") + " compared, " +
                   std::to_string(matches.size()) + (matches.size() == 1 ? " match" : " matches"))
              : Internal(kDropped);
  return true;
}

bool PlaceRecognitionNode::QueryImage(QueryImageRequest& request, QueryImageResponse& response) {
  std::string error;
  const std::optional<Camera> camera = FromMessage(request.camera, &error);
  if (!camera) {
    response.status = InvalidArgument("camera: " + error);
    return true;
  }
  const DecodeResult decoded = DecodeImage(request.image.data, options_.frontend.max_pixels);
  const bool has_size = decoded.bgr.cols == camera->width && decoded.bgr.rows == camera->height;
  if (decoded.bgr.empty() || !has_size) {
    response.status = InvalidArgument(
        "image: " + (decoded.bgr.empty() ? decoded.reason : "its size is not the camera's"));
    return true;
  }
  const auto features = FindFeatures(decoded.bgr, *camera, options_.frontend);
  std::vector<PlaceMatch> matches;
  const bool has_run =
      RunAndWait([&] { matches = recognizer_.QueryImage(features, *camera); }, kCallLane, &worker_);
  for (const PlaceMatch& match : matches) response.matches.push_back(ToMessage(match, 0));
  response.status =
      has_run ? Ok(std::to_string(matches.size()) + " places match") : Internal(kDropped);
  return true;
}

}  // namespace rovio_sfm
