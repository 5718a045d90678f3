// The services of MappingNode; see mapping_node.h.
#include <filesystem>
#include <optional>
#include <utility>

#include "rovio_sfm/app/store_folder.h"
#include "rovio_sfm/ros/answer_merge.h"
#include "rovio_sfm/ros/map_messages.h"
#include "rovio_sfm/ros/map_store_files.h"
#include "rovio_sfm/ros/mapping_node.h"
#include "rovio_sfm/ros/status.h"
#include "rovio_sfm/ros/topics.h"
#include "rovio_sfm/util/count_text.h"
#include "rovio_sfm/util/steady_clock.h"

namespace rovio_sfm {
namespace {

constexpr char kReadOnly[] = "~localize is on: the maps are only read";
constexpr char kNoStore[] = "no store is kept: ~output_dir is empty or ~keep_store false";
constexpr char kDropped[] = "the call was refused: too many wait already, or the node ends";

}  // namespace

void MappingNode::AdvertiseServices() {
  ros::NodeHandle node(node_);
  node.setCallbackQueue(&service_queue_);
  services_ = {
      node.advertiseService(topics::kListSessions, &MappingNode::ListSessions, this),
      node.advertiseService(topics::kGetFrames, &MappingNode::GetFrames, this),
      node.advertiseService(topics::kStartSession, &MappingNode::StartSession, this),
      node.advertiseService(topics::kFinishSession, &MappingNode::FinishSession, this),
      node.advertiseService(topics::kExportMap, &MappingNode::ExportMap, this),
      node.advertiseService(topics::kReset, &MappingNode::Reset, this),
      node.advertiseService(topics::kSaveMap, &MappingNode::SaveMap, this),
      node.advertiseService(topics::kLoadMap, &MappingNode::LoadMap, this),
      node.advertiseService(topics::kMergeSessions, &MappingNode::MergeSessions, this),
      node.advertiseService(topics::kUnmergeSession, &MappingNode::UnmergeSession, this),
  };
}

bool MappingNode::ListSessions(ListSessionsRequest&, ListSessionsResponse& response) {
  const MapPicture picture = engine_.Picture();
  response.sessions = SessionSummaries(*picture.snapshot);
  response.maps = MapSummaries(*picture.snapshot);
  response.status = Ok(CountText(response.sessions.size(), "session") + " in " +
                       CountText(response.maps.size(), "map"));
  return true;
}

bool MappingNode::GetFrames(GetFramesRequest& request, GetFramesResponse& response) {
  response = history_.Page(request);
  const bool holds_first =
      !response.frames.empty() && response.frames.front().id.index == request.first.index;
  if (holds_first || !engine_.keeps_store()) return true;
  GetFramesResponse kept = PageOfStore(options_.output_dir, request);
  if (!kept.frames.empty()) response = std::move(kept);
  return true;
}

bool MappingNode::StartSession(StartSessionRequest& request, StartSessionResponse& response) {
  std::optional<ClosedSession> closed;
  response.status = CloseSession(request.robot, &closed);
  return true;
}

bool MappingNode::FinishSession(FinishSessionRequest& request, FinishSessionResponse& response) {
  std::optional<ClosedSession> closed;
  response.status = CloseSession(request.robot, &closed);
  if (!closed) return true;
  if (closed->has_frames) {
    response.session = closed->id.value;
  } else {
    response.status = FailedPrecondition("the newest session of " + request.robot + ", " +
                                         std::to_string(closed->id.value) + ", has no frames yet");
  }
  return true;
}

Status MappingNode::CloseSession(const std::string& robot, std::optional<ClosedSession>* closed) {
  std::string error;
  if (!IsValidRobotName(robot, &error)) return InvalidArgument(error);
  if (options_.localize) return FailedPrecondition(kReadOnly);
  const auto close = [&] {
    gap_filler_.EndWait(robot, SteadySeconds());  // frames that came before the call belong to it
    *closed = engine_.FinishSession(robot);
  };
  if (!RunAndWait(close, kCallLane, &worker_)) return Internal(kDropped);
  if (!*closed) return NotFound("robot " + robot + " has no session that runs");
  return Ok("session " + std::to_string((*closed)->id.value) + " of " + robot +
            " is finished; its next frame begins another");
}

bool MappingNode::Reset(ResetRequest& request, ResetResponse& response) {
  if (options_.localize) {
    response.status = FailedPrecondition(kReadOnly);
    return true;
  }
  if (!request.confirm) {
    response.status = InvalidArgument("confirm: expected true; all maps would be forgotten");
    return true;
  }
  std::filesystem::path aside;
  const auto reset = [&] {
    gap_filler_.EndAllWaits(SteadySeconds());
    aside = engine_.Reset();
    history_.Clear();
  };
  std::string message = "all maps are forgotten";
  const bool is_reset = RunAndWait(reset, kCallLane, &worker_);
  if (!aside.empty()) message += "; they are kept in " + aside.string();
  response.status = is_reset ? Ok(message) : Internal(kDropped);
  return true;
}

bool MappingNode::SaveMap(SaveMapRequest& request, SaveMapResponse& response) {
  if (!engine_.keeps_store()) {
    response.status = FailedPrecondition(kNoStore);
  } else if (!RunAndWait([this] { engine_.Save(); }, kCallLane, &worker_)) {
    response.status = Internal(kDropped);
  } else {
    response = CopyStore(options_.output_dir, request);
    finish_.RefreshGrid();
  }
  return true;
}

bool MappingNode::LoadMap(LoadMapRequest& request, LoadMapResponse& response) {
  std::string error;
  const std::filesystem::path file = StorePathOf(options_.output_dir, request.name, &error);
  if (options_.localize) {
    response.status = FailedPrecondition(kReadOnly);
  } else if (!engine_.keeps_store()) {
    response.status = FailedPrecondition(kNoStore);
  } else if (!request.confirm) {
    response.status = InvalidArgument("confirm: expected true; the maps of now would be put aside");
  } else if (file.empty()) {
    response.status = InvalidArgument(error);
  } else if (!std::filesystem::exists(file)) {
    response.status = NotFound("name: there is no " + file.string());
  } else {
    LoadStore(file, &response);
  }
  return true;
}

void MappingNode::LoadStore(const std::filesystem::path& file, LoadMapResponse* response) {
  std::string error;
  const auto load = [&] {
    try {
      response->put_aside = engine_.Load(file).string();
      gap_filler_.EndAllWaits(SteadySeconds());
      history_.Clear();
    } catch (const std::exception& failure) {  // no store, another version, a full disk
      error = failure.what();
    }
  };
  if (!RunAndWait(load, kCallLane, &worker_)) {
    response->status = Internal(kDropped);
  } else if (!error.empty()) {
    response->status = InvalidArgument(error);
  } else {
    response->status = Ok("mapping goes on with the maps of " + file.string());
  }
}

bool MappingNode::MergeSessions(MergeSessionsRequest& request, MergeSessionsResponse& response) {
  const auto merge = [&] { response = AnswerMerge(request, &engine_); };
  if (options_.localize) {
    response.status = FailedPrecondition(kReadOnly);
  } else if (!RunAndWait(merge, kCallLane, &worker_)) {
    response.status = Internal(kDropped);
  }
  return true;
}

bool MappingNode::UnmergeSession(UnmergeSessionRequest& request, UnmergeSessionResponse& response) {
  const auto unmerge = [&] { response = AnswerUnmerge(request, &engine_); };
  if (options_.localize) {
    response.status = FailedPrecondition(kReadOnly);
  } else if (!RunAndWait(unmerge, kCallLane, &worker_)) {
    response.status = Internal(kDropped);
  }
  return true;
}

}  // namespace rovio_sfm
