#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rovio_sfm/ExportMap.h>
#include <rovio_sfm/FinishSession.h>
#include <rovio_sfm/FrameEventMsg.h>
#include <rovio_sfm/GetFrames.h>
#include <rovio_sfm/ListSessions.h>
#include <rovio_sfm/LoadMap.h>
#include <rovio_sfm/MergeSessions.h>
#include <rovio_sfm/PlaceMatchMsg.h>
#include <rovio_sfm/Reset.h>
#include <rovio_sfm/SaveMap.h>
#include <rovio_sfm/StartSession.h>
#include <rovio_sfm/UnmergeSession.h>

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/app/gap_filler.h"
#include "rovio_sfm/app/live_news.h"
#include "rovio_sfm/app/mapping_engine.h"
#include "rovio_sfm/app/mapping_node_options.h"
#include "rovio_sfm/ros/diagnostic_pace.h"
#include "rovio_sfm/ros/event_history.h"
#include "rovio_sfm/ros/final_maps.h"
#include "rovio_sfm/ros/finish_actions.h"
#include "rovio_sfm/ros/frame_fetcher.h"
#include "rovio_sfm/ros/frame_subscriber.h"
#include "rovio_sfm/ros/job_worker.h"
#include "rovio_sfm/ros/map_publisher.h"
#include "rovio_sfm/ros/waiting_hints.h"

namespace rovio_sfm {

// Frame events of all robots and place matches in, maps out. The callbacks of the main thread
// convert and push; the worker owns the mapper, and waits for nobody: missing frames are fetched on
// other threads; services have threads of their own too, so that a call that waits for the worker
// holds up nothing else.
class MappingNode {
 public:
  MappingNode(const MappingNodeOptions& options, ros::NodeHandle node,
              ros::NodeHandle private_node);
  ~MappingNode();

  // Writes the maps as they stand, maps what is queued (as long as drain_s allows), finishes all
  // sessions and writes the maps again. False where they are not on disk. Ends the program where,
  // after a signal, the time is used up.
  bool End();

  // Diagnostics, and what is waited for; call at least ten times a second.
  void Tick();

 private:
  // What the worker has to do, by kind; WorkerLanes has the bounds.
  enum Lane : size_t { kFrameLane, kMatchLane, kCallLane, kAnswerLane, kClockLane };

  void AdvertiseServices();
  void StartTimers();
  void OnFrame(const FrameEventMsg::ConstPtr& message, FrameEvent event);
  void OnPlaceMatch(const PlaceMatchMsg::ConstPtr& message);
  void OnAnswer(const GapFetch& fetch, std::vector<FetchedFrame> frames);  // threads of fetcher_
  bool IsTimeUp() const;
  // Why something was refused within the last half minute; else empty.
  std::string RecentRefusal() const;
  void SummarizeMaps(const MapPicture& picture,
                     diagnostic_updater::DiagnosticStatusWrapper* status) const;
  void Summarize(const MapPicture& picture,
                 diagnostic_updater::DiagnosticStatusWrapper* status) const;
  void Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);
  IngestCounters Counters() const;

  bool ListSessions(ListSessionsRequest& request, ListSessionsResponse& response);
  bool GetFrames(GetFramesRequest& request, GetFramesResponse& response);
  bool StartSession(StartSessionRequest& request, StartSessionResponse& response);
  bool FinishSession(FinishSessionRequest& request, FinishSessionResponse& response);
  bool ExportMap(ExportMapRequest& request, ExportMapResponse& response);
  bool Reset(ResetRequest& request, ResetResponse& response);
  bool SaveMap(SaveMapRequest& request, SaveMapResponse& response);
  bool LoadMap(LoadMapRequest& request, LoadMapResponse& response);
  bool MergeSessions(MergeSessionsRequest& request, MergeSessionsResponse& response);
  bool UnmergeSession(UnmergeSessionRequest& request, UnmergeSessionResponse& response);
  void LoadStore(const std::filesystem::path& file, LoadMapResponse* response);
  Status CloseSession(const std::string& robot, std::optional<ClosedSession>* closed);

  // A picture of the maps and the model of one, both of one moment.
  struct MapParts {
    std::shared_ptr<const MapSnapshot> snapshot;
    std::optional<MapModel> model;
    std::string error;  // why there is none
  };
  MapParts TakeMapParts(const ExportMapRequest& request) const;  // worker
  FinishSources SourcesOfActions();
  KeptFrames Frames() const;

  ArrivedFrame Arrived(const FrameEventMsg::ConstPtr& message, const FrameEvent& event);
  void Map(const FrameEventMsg::ConstPtr& message, const FrameEvent& event);  // worker
  void AddMatch(const PlaceMatch& match);                                     // worker
  void CountGaps();                                                           // worker
  void SaveNowAndThen(double now_s);                                          // worker
  void DrainAndAdjust();
  [[noreturn]] void EndUnadjusted();
  void WriteMaps();  // but those that are only read: they are on disk

  const MappingNodeOptions options_;
  ros::NodeHandle node_;
  MappingEngine engine_;
  LiveNews news_;
  FinalMaps maps_;
  bool has_ended_ = false;
  WaitingHints hints_;
  MapPublisher publisher_;
  EventHistory history_;
  FrameFetcher fetcher_;
  GapFiller gap_filler_;                                            // of the worker
  double next_save_s_ = 0.0;                                        // likewise
  NewestRefusal refused_matches_, unmapped_;                        // unmapped: well-formed frames
  std::atomic<uint64_t> num_late_events_{0}, num_late_matches_{0};  // queued, dropped at the end
  std::atomic<uint64_t> num_lost_gaps_{0}, num_held_{0};            // of gap_filler_
  std::atomic<double> give_up_s_{0.0};                              // steady time; 0: never
  ros::CallbackQueue service_queue_;
  std::vector<ros::ServiceServer> services_;
  ros::AsyncSpinner service_spinner_;
  ros::WallTimer edge_timer_, map_timer_;
  diagnostic_updater::Updater diagnostics_;
  DiagnosticPace pace_{&diagnostics_};
  JobWorker worker_;                  // its thread uses the others
  FrameSubscriber frame_subscriber_;  // pushes to the worker
  ros::Subscriber match_subscriber_;  // likewise
  FinishActions finish_;              // likewise, by a thread of its own
};

}  // namespace rovio_sfm
