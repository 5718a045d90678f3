#pragma once

#include <ros/ros.h>
#include <tf2_ros/transform_broadcaster.h>

#include <map>
#include <string>

#include "rovio_sfm/ros/mapping_engine.h"

namespace rovio_sfm {

// Events that never became part of a map, for map_status.
struct IngestCounters {
  uint64_t refused = 0;
  uint64_t dropped = 0;
};

// Sends pictures of the maps: tf, path, cameras, cloud, map_status, poses. Large messages go out
// only when something changed and somebody listens. Used by one thread, but for PublishPose, which
// may run beside the others.
class MapPublisher {
 public:
  MapPublisher(ros::NodeHandle node, double cloud_period_s);

  // All edges in one message; call ten times a second.
  void PublishEdges(const MapPicture& picture);
  // Everything else that changed; `is_final`: the cloud goes out though its period is not over.
  void PublishMap(const MapPicture& picture, const IngestCounters& counters, bool is_final);
  // The pose of a registered frame, on pose and, for a keyframe, keyframe_pose.
  void PublishPose(const MapPicture& picture, SessionId session, uint32_t index);

 private:
  // A latched topic and the version of the picture that went out last.
  struct Output {
    ros::Publisher publisher;
    uint64_t version = 0;
  };

  template <typename Message>
  Output& OutputOf(const std::string& topic);
  bool IsDue(Output* output, uint64_t version) const;
  void PublishPaths(const MapSnapshot& snapshot, const ros::Time& now);
  void PublishCameras(const MapSnapshot& snapshot, const ros::Time& now);
  void PublishClouds(const MapSnapshot& snapshot, const ros::Time& now, bool is_final);
  void PublishStatus(const MapPicture& picture, const IngestCounters& counters);

  ros::NodeHandle node_;
  double cloud_period_s_;
  ros::SteadyTime last_cloud_;
  ros::Time last_edges_;
  tf2_ros::TransformBroadcaster edges_;
  std::map<std::string, Output> outputs_;  // by topic
  ros::Publisher pose_, keyframe_pose_;
};

}  // namespace rovio_sfm
