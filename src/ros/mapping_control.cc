#include "rovio_sfm/ros/mapping_control.h"

#include <rovio_sfm/FinishSession.h>
#include <rovio_sfm/MergeSessions.h>
#include <rovio_sfm/SaveMap.h>
#include <rovio_sfm/UnmergeSession.h>

#include <chrono>

#include "rovio_sfm/ros/topics.h"

namespace rovio_sfm {
namespace {

constexpr std::chrono::milliseconds kDropAgain(20);
constexpr bool kPersistent = true;  // only such a client's connection can be dropped from outside

}  // namespace

ControlReply MappingControl::Call(const ControlOrder& order) {
  if (const auto* finish = std::get_if<FinishSessionOrder>(&order)) {
    FinishSessionRequest request;
    request.robot = finish->robot;
    return CallService<rovio_sfm::FinishSession>(topics::kFinishSession, request);
  }
  if (const auto* merge = std::get_if<MergeSessionsOrder>(&order)) {
    MergeSessionsRequest request;
    request.session_a = merge->session_a;
    request.session_b = merge->session_b;
    request.force = merge->force;
    return CallService<rovio_sfm::MergeSessions>(topics::kMergeSessions, request);
  }
  if (const auto* unmerge = std::get_if<UnmergeSessionOrder>(&order)) {
    UnmergeSessionRequest request;
    request.session = unmerge->session;
    return CallService<rovio_sfm::UnmergeSession>(topics::kUnmergeSession, request);
  }
  const auto& save = std::get<SaveMapOrder>(order);
  SaveMapRequest request;
  request.name = save.name;
  request.overwrite = save.overwrite;
  return CallService<rovio_sfm::SaveMap>(topics::kSaveMap, request);
}

template <typename Service>
ControlReply MappingControl::CallService(const char* name,
                                         const typename Service::Request& request) {
  ros::ServiceClient client = node_.serviceClient<Service>(name, kPersistent);
  typename Service::Response response;
  if (!Enter(client)) return {false, "map_web is ending"};
  const bool is_answered = client.isValid() && client.call(request, response);
  Leave();
  if (!is_answered) {
    return {false, std::string(name) + ": no answer; is mapping running at " +
                       node_.resolveName(name) + "?"};
  }
  return {response.status.code == Status::OK, response.status.message};
}

// A call may just be about to begin on a new connection: so it is dropped until the call is over.
void MappingControl::Stop() {
  MutexLock lock(mutex_);
  is_stopped_ = true;
  while (is_calling_) {
    client_.shutdown();
    idle_.wait_for(mutex_, kDropAgain);
  }
}

bool MappingControl::Enter(const ros::ServiceClient& client) {
  const MutexLock lock(mutex_);
  if (is_stopped_) return false;
  client_ = client;
  is_calling_ = true;
  return true;
}

void MappingControl::Leave() {
  const MutexLock lock(mutex_);
  is_calling_ = false;
  client_ = ros::ServiceClient();
  idle_.notify_all();
}

}  // namespace rovio_sfm
