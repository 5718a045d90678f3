#pragma once

#include <ros/ros.h>
#include <tf2_ros/transform_broadcaster.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "rovio_sfm/app/mapping_engine.h"
#include "rovio_sfm/ros/map_status_message.h"

namespace rovio_sfm {

// Sends pictures of the maps: tf, path, cameras, cloud, map_status, poses. Large messages go out
// only when something changed and somebody listens. Used by one thread, but for PublishPose, which
// may run beside the others.
class MapPublisher {
 public:
  MapPublisher(ros::NodeHandle node, double cloud_period_s);

  // All edges in one message; call ten times a second. After a merge, an unmerge or a new scale
  // everything else goes with them, so that all agree.
  void PublishEdges(const MapPicture& picture, const IngestCounters& counters);
  // Everything else that changed; `at_once`: the cloud goes out though its period is not over.
  void PublishMap(const MapPicture& picture, const IngestCounters& counters, bool at_once);
  // The pose of a registered frame, on pose and, for a keyframe, keyframe_pose.
  void PublishPose(const MapPicture& picture, SessionId session, uint32_t index);

 private:
  // A latched topic and the version of the picture that went out last.
  struct Output {
    ros::Publisher publisher;
    uint64_t version = 0;
  };

  // What lengths and places of a session in its map depend on.
  struct Gauge {
    SessionId session;
    MapId map;
    uint32_t revision = 0;
    double metres_per_unit = 0.0;
  };

  bool TakeGauges(const MapSnapshot& snapshot);
  template <typename Message>
  Output& OutputOf(const std::string& topic);
  bool IsDue(Output* output, uint64_t version) const;
  void PublishPaths(const MapSnapshot& snapshot, const ros::Time& now);
  void PublishCameras(const MapPicture& picture, const ros::Time& now);
  void PublishClouds(const MapSnapshot& snapshot, const ros::Time& now);
  void PublishCloud(const MapSnapshot& snapshot, MapId map, const std::string& topic,
                    const ros::Time& now);
  void PublishStatus(const MapPicture& picture, const IngestCounters& counters);

  ros::NodeHandle node_;
  double cloud_period_s_;
  ros::SteadyTime last_cloud_;
  ros::Time last_edges_;
  std::vector<Gauge> gauges_;  // of the last edges, by session
  std::set<MapId> apart_;      // maps with a cloud of their own: where they lie is not known
  tf2_ros::TransformBroadcaster edges_;
  std::map<std::string, Output> outputs_;  // by topic
  ros::Publisher pose_, keyframe_pose_;
};

}  // namespace rovio_sfm
