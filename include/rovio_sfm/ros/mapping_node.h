#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rovio_sfm/ExportMap.h>
#include <rovio_sfm/FinishSession.h>
#include <rovio_sfm/FrameEventMsg.h>
#include <rovio_sfm/GetFrames.h>
#include <rovio_sfm/ListSessions.h>
#include <rovio_sfm/Reset.h>
#include <rovio_sfm/StartSession.h>

#include <atomic>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "rovio_sfm/ros/event_history.h"
#include "rovio_sfm/ros/map_publisher.h"
#include "rovio_sfm/ros/mapping_engine.h"
#include "rovio_sfm/ros/mapping_node_options.h"
#include "rovio_sfm/util/worker.h"

namespace rovio_sfm {

// Frame events of all robots in, maps out. The callbacks of the main thread convert and push; the
// worker owns the mapper; services have threads of their own, so that a call that waits for the
// worker holds up nothing else.
class MappingNode {
 public:
  MappingNode(const MappingNodeOptions& options, ros::NodeHandle node,
              ros::NodeHandle private_node);
  // Maps what is queued (as long as drain_s allows), finishes all sessions and writes the map.
  ~MappingNode();

  void Tick() { diagnostics_.update(); }

 private:
  using Job = std::function<void()>;
  static constexpr size_t kJobQueue = 500;  // events and calls; drop oldest, counted

  void SubscribeFrames();
  void AdvertiseServices();
  void OnFrame(const std::string& robot, const FrameEventMsg::ConstPtr& message);
  void Refuse(const std::string& reason);
  void Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);
  IngestCounters Counters() const;

  bool ListSessions(ListSessionsRequest& request, ListSessionsResponse& response);
  bool GetFrames(GetFramesRequest& request, GetFramesResponse& response);
  bool StartSession(StartSessionRequest& request, StartSessionResponse& response);
  bool FinishSession(FinishSessionRequest& request, FinishSessionResponse& response);
  bool ExportMap(ExportMapRequest& request, ExportMapResponse& response);
  bool Reset(ResetRequest& request, ResetResponse& response);
  Status CloseSession(const std::string& robot, uint32_t* session);
  // Runs a job on the worker and waits for it; false if the queue dropped it or has closed.
  bool RunOnWorker(Job job);

  void Ingest(const FrameEventMsg::ConstPtr& message, const FrameEvent& event);  // worker, as below
  void FetchMissing(const FrameId& id);
  void Map(const FrameEventMsg::ConstPtr& message, const FrameEvent& event);
  void WriteFinalMap() const;

  const MappingNodeOptions options_;
  ros::NodeHandle node_;
  MappingEngine engine_;
  MapPublisher publisher_;
  EventHistory history_;
  std::atomic<uint64_t> num_refused_{0};
  std::atomic<uint64_t> num_given_up_{0};                // queued events dropped at the end
  std::atomic<double> give_up_s_{0.0};                   // steady time; 0: never
  std::map<std::string, ros::ServiceClient> frontends_;  // get_frames, by robot
  std::vector<ros::Subscriber> subscribers_;
  ros::CallbackQueue service_queue_;
  std::vector<ros::ServiceServer> services_;
  ros::AsyncSpinner service_spinner_;
  ros::WallTimer edge_timer_, map_timer_;
  diagnostic_updater::Updater diagnostics_;
  Worker<Job> worker_;  // last: its thread uses the others
};

}  // namespace rovio_sfm
