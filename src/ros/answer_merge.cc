#include "rovio_sfm/ros/answer_merge.h"

#include <optional>
#include <string>

#include "rovio_sfm/report/level_session.h"
#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/map_frames.h"
#include "rovio_sfm/ros/merge_report_message.h"
#include "rovio_sfm/ros/status.h"
#include "rovio_sfm/util/option_text.h"

namespace rovio_sfm {
namespace {

constexpr double kMinScale = 1e-3, kMaxScale = 1e3;

// Whether the session may be merged; else status says why not.
bool IsMergeable(const MapSnapshot& snapshot, uint32_t number, Status* status) {
  const SessionSnapshot* session = FindSession(snapshot, SessionId{number});
  if (session == nullptr) {
    *status = NotFound("there is no session " + std::to_string(number));
  } else if (!LevelInUnitOfMap(*session)) {
    *status = FailedPrecondition("session " + std::to_string(number) + " has no posed frame yet");
  } else {
    return true;
  }
  return false;
}

// session_<b>/map from session_<a>/map, as the request says.
std::optional<Sim3> ReadPlacement(const MergeSessionsRequest& request, Status* status) {
  std::string error;
  const std::optional<Rigid3> b_from_a = FromTransform(request.b_from_a, &error);
  if (!b_from_a) {
    *status = InvalidArgument("b_from_a." + error);
    return std::nullopt;
  }
  if (!(request.scale >= kMinScale && request.scale <= kMaxScale)) {
    *status = InvalidArgument("scale = " + TextOf(request.scale) + ": expected 0.001 to 1000");
    return std::nullopt;
  }
  return Sim3{request.scale, b_from_a->rotation, b_from_a->translation};
}

void MergeByHand(const MergeSessionsRequest& request, MappingEngine* engine,
                 MergeSessionsResponse* response) {
  const std::optional<Sim3> b_from_a = ReadPlacement(request, &response->status);
  if (!b_from_a) return;
  response->report = ToMessage(
      engine->MergeAt(SessionId{request.session_a}, SessionId{request.session_b}, *b_from_a));
}

}  // namespace

MergeSessionsResponse AnswerMerge(const MergeSessionsRequest& request, MappingEngine* engine) {
  MergeSessionsResponse response;
  response.report.verdict = MergeReportMsg::REFUSED;
  const MapPicture picture = engine->Picture();
  if (request.session_a == request.session_b) {
    response.status = InvalidArgument("session_b = " + std::to_string(request.session_b) +
                                      ": expected another session than session_a");
    return response;
  }
  for (const uint32_t number : {request.session_a, request.session_b}) {
    if (!IsMergeable(*picture.snapshot, number, &response.status)) return response;
  }
  if (request.by_hand) {
    MergeByHand(request, engine, &response);
  } else {
    response.report = ToMessage(
        engine->Merge(SessionId{request.session_a}, SessionId{request.session_b}, request.force));
  }
  if (response.status.code != Status::OK) return response;
  const bool is_merged = response.report.verdict == MergeReportMsg::ACCEPTED;
  response.status = is_merged ? Ok("merged: " + response.report.reason)
                              : FailedPrecondition("not merged: " + response.report.reason);
  return response;
}

UnmergeSessionResponse AnswerUnmerge(const UnmergeSessionRequest& request, MappingEngine* engine) {
  UnmergeSessionResponse response;
  const std::string name = "session " + std::to_string(request.session);
  const MapPicture picture = engine->Picture();
  if (FindSession(*picture.snapshot, SessionId{request.session}) == nullptr) {
    response.status = NotFound("there is no " + name);
    return response;
  }
  response.undone = ToMessages(engine->Unmerge(SessionId{request.session}));
  response.status =
      response.undone.empty()
          ? FailedPrecondition(name + " is alone in its map")
          : Ok(std::to_string(response.undone.size()) + " merges of " + name + " are undone");
  return response;
}

}  // namespace rovio_sfm
