#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rovio_sfm/FindOverlaps.h>
#include <rovio_sfm/FrameEventMsg.h>
#include <rovio_sfm/PlaceMatchMsg.h>
#include <rovio_sfm/PlaceStatus.h>
#include <rovio_sfm/QueryImage.h>
#include <rovio_sfm/SessionSummary.h>

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/app/place_recognition_node_options.h"
#include "rovio_sfm/recognition/place_recognizer.h"
#include "rovio_sfm/ros/diagnostic_pace.h"
#include "rovio_sfm/ros/fetch_frames.h"
#include "rovio_sfm/ros/frame_subscriber.h"
#include "rovio_sfm/ros/job_worker.h"
#include "rovio_sfm/ros/waiting_hints.h"
#include "rovio_sfm/scene/frame_cache.h"
#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm {

// Frame events of all robots in, place matches out. At its start, and wherever a drive has a gap,
// it fetches from mapping and the frontends what it missed, so it may be restarted at any time; the
// matches of frames fetched are published (again). The worker owns the recognizer.
class PlaceRecognitionNode {
 public:
  PlaceRecognitionNode(const PlaceRecognitionNodeOptions& options, ros::NodeHandle node,
                       ros::NodeHandle private_node);
  ~PlaceRecognitionNode();

  // Diagnostics, and what is waited for; call at least ten times a second.
  void Tick();

 private:
  // What the worker has to do, by kind; WorkerLanes has the bounds.
  enum Lane : size_t { kFrameLane = 0, kCallLane = 1 };

  void AdvertiseServices();
  bool FindOverlaps(FindOverlapsRequest& request, FindOverlapsResponse& response);
  bool QueryImage(QueryImageRequest& request, QueryImageResponse& response);
  std::optional<SessionSummary> FindSession(uint32_t number, Status* status);
  void Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);
  // Tells a subscriber that connects what was published before, the newest matches: after a restart
  // mapping may be slower to connect than the first matches are found. It ignores what it knows.
  void TellAgain(const ros::SingleSubscriberPublisher& subscriber) EXCLUDES(mutex_);
  PlaceStatus LastStatus() const EXCLUDES(mutex_);

  void OnFrame(const FrameEventMsg& message, FrameEvent event);

  // All below run on the worker.
  void FetchKnownDrives();
  void Ingest(const FrameEvent& event);
  void FetchMissing(const FrameId& id);
  void Recognize(const FrameEvent& event);
  std::shared_ptr<const FrameFeatures> FetchFeatures(const FrameId& id);
  bool CallMapping(GetFramesRequest& request, GetFramesResponse& response);
  std::vector<PlaceMatch> Overlaps(const SessionSummary& a, const SessionSummary& b,
                                   size_t* num_compared);
  void Publish(const std::vector<PlaceMatch>& matches, int64_t stamp_ns) EXCLUDES(mutex_);
  void PublishStatus(int64_t stamp_ns, double query_s) EXCLUDES(mutex_);

  const PlaceRecognitionNodeOptions options_;
  ros::NodeHandle node_;
  FrameCache cache_;
  PlaceRecognizer recognizer_;
  std::map<DriveId, uint32_t> next_indices_;
  uint64_t num_events_ = 0, num_fetched_ = 0, num_missing_ = 0;
  mutable Mutex mutex_;
  PlaceStatus status_ GUARDED_BY(mutex_);
  std::deque<PlaceMatchMsg> told_ GUARDED_BY(mutex_);  // drop oldest
  ros::Publisher match_publisher_, status_publisher_;
  ros::ServiceClient mapping_frames_, mapping_sessions_;
  std::map<std::string, ros::ServiceClient> frontends_;  // get_frames, by robot
  ros::CallbackQueue service_queue_;
  std::vector<ros::ServiceServer> services_;
  ros::AsyncSpinner service_spinner_;
  diagnostic_updater::Updater diagnostics_;
  DiagnosticPace pace_{&diagnostics_};
  WaitingHints hints_;
  JobWorker worker_;            // its thread uses the others
  FrameSubscriber subscriber_;  // pushes to the worker
};

}  // namespace rovio_sfm
