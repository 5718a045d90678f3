#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <dynamic_reconfigure/server.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/app/frontend_node_options.h"
#include "rovio_sfm/app/image_gate.h"
#include "rovio_sfm/frontend/frontend.h"
#include "rovio_sfm/ros/camera_subscribers.h"
#include "rovio_sfm/ros/diagnostic_pace.h"
#include "rovio_sfm/ros/event_history.h"
#include "rovio_sfm/ros/frontend_thresholds.h"
#include "rovio_sfm/ros/newest_refusal.h"
#include "rovio_sfm/ros/robot_sensors.h"
#include "rovio_sfm/ros/waiting_hints.h"
#include "rovio_sfm/util/mutex.h"
#include "rovio_sfm/util/worker.h"

namespace rovio_sfm {

// One robot's images in, frame events out. Callbacks (one thread) put image, odometry and head pose
// together and push; the worker thread decodes, extracts, matches and publishes. Every image
// carries the options it is to be handled with, so that a change has its place between two images.
class FrontendNode {
 public:
  // `nonce` tells this frontend's drives from those of its last start.
  FrontendNode(const FrontendNodeOptions& options, uint32_t nonce, ros::NodeHandle node,
               ros::NodeHandle private_node);
  // Handles the images that are queued and publishes their events.
  ~FrontendNode();

  // Releases images that waited long enough, and looks for topics that are to be guessed; call at
  // least ten times a second. Throws std::runtime_error where there are several of a kind.
  void Tick();

 private:
  static constexpr size_t kImageQueue = 2;  // images before the worker; drop oldest

  // What the worker thread did, for the diagnostics.
  struct Progress {
    FrontendCounters counters;
    std::string last_refusal;
    uint64_t num_with_odometry = 0;
    double last_duration_s = 0.0;
  };
  struct Job {
    ImageEvent image;
    std::shared_ptr<const FrontendOptions> options;
  };
  // The last keyframe, for drawing.
  struct Drawn {
    FrameEvent event;
    cv::Mat bgr;
  };

  void Advertise();
  CameraCallbacks Callbacks();

  template <typename Message>
  void OnImage(const boost::shared_ptr<const Message>& message);
  void OnCameraInfo(const sensor_msgs::CameraInfo::ConstPtr& message);
  void OnOdometry(const nav_msgs::Odometry::ConstPtr& message);
  void OnThresholds(FrontendThresholdsConfig& thresholds, uint32_t level);
  void CountMalformed(const std::string& reason);
  void ReleaseImages();
  std::vector<AwaitedTopic> Awaited() const;
  bool GetFrames(GetFramesRequest& request, GetFramesResponse& response);
  void Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  void Handle(const Job& job);  // worker thread, as the rest
  void Publish(const FrameEvent& event, const PreparedImage& image);
  void PublishMatches(const FrameEvent& event, const cv::Mat& bgr);
  void NoteProgress(const std::optional<FrameEvent>& event, double duration_s);

  const FrontendNodeOptions options_;                        // as at the start
  std::shared_ptr<const FrontendOptions> frontend_options_;  // of the images to come
  ros::NodeHandle node_;
  tf2_ros::Buffer transforms_;
  tf2_ros::TransformListener transform_listener_;
  RobotSensors sensors_;
  ImageGate gate_;
  NewestRefusal malformed_;
  bool has_image_ = false, has_camera_info_ = false;  // whether one came, of use or not
  WaitingHints hints_;
  EventHistory history_;
  mutable Mutex mutex_;
  Progress progress_ GUARDED_BY(mutex_);

  Frontend frontend_;           // worker thread only
  std::optional<Drawn> drawn_;  // worker thread only
  ros::Publisher frames_, preview_, matches_;
  CameraSubscribers subscribers_;
  ros::ServiceServer get_frames_;
  diagnostic_updater::Updater diagnostics_;
  DiagnosticPace pace_{&diagnostics_};
  boost::recursive_mutex thresholds_mutex_;  // of the server, which wants one
  dynamic_reconfigure::Server<FrontendThresholdsConfig> thresholds_;
  Worker<Job> worker_;  // last: its thread uses the others
};

}  // namespace rovio_sfm
