#pragma once

#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_ros/transform_broadcaster.h>
#include <visualization_msgs/MarkerArray.h>

#include <functional>
#include <map>
#include <string>

#include "rovio_sfm/app/changed_parts.h"
#include "rovio_sfm/app/mapping_engine.h"
#include "rovio_sfm/ros/map_status_message.h"

namespace rovio_sfm {

// Sends pictures of the maps: tf, paths, cameras, cloud, map_status, poses. Paths, cameras and
// clouds go out part by part, where a part changed and somebody listens; who begins to listen is
// sent at once what was shown last. Used by one thread, which also runs the callbacks of the node's
// queue, but for PublishPose, which may run beside the others.
class MapPublisher {
 public:
  MapPublisher(ros::NodeHandle node, double cloud_period_s);

  // All edges in one message; call ten times a second. After a merge, an unmerge or a new scale
  // everything that it changed goes with them, so that all agree.
  void PublishEdges(const MapPicture& picture, const IngestCounters& counters);
  // Everything else that changed; `at_once`: clouds go out though their period is not over.
  void PublishMap(const MapPicture& picture, const IngestCounters& counters, bool at_once);
  // The pose of a registered frame, on pose and, for a keyframe, keyframe_pose.
  void PublishPose(const MapPicture& picture, SessionId session, uint32_t index);
  // The same of a frame that was localized in a session: on pose alone.
  void PublishPose(const MapPicture& picture, const Localization& localization);

 private:
  void PublishPose(const SessionSnapshot& session, const FrameSnapshot& frame);

  // A latched topic; stale: what it says now was not sent, because nobody listened.
  struct Output {
    ros::Publisher publisher;
    bool is_stale = false;
  };

  template <typename Message>
  void Advertise(const std::string& topic, std::function<Message()> newest, Output* output);
  template <typename Message>
  void Send(const std::function<Message()>& newest, Output* output);
  Output& PathOutput(SessionId id);
  Output& CloudOutput(const CloudPlace& place);
  nav_msgs::Path NewestPath(SessionId id) const;
  sensor_msgs::PointCloud2 NewestCloud(const CloudPlace& place) const;
  void AdvertiseMarkers();
  void PublishSessions(const MapPicture& picture);
  void PublishClouds(const MapPicture& picture);

  ros::NodeHandle node_;
  double cloud_period_s_;
  ros::SteadyTime last_cloud_;
  ros::Time last_edges_;
  ChangedParts parts_;
  MapPicture shown_;         // paths and cameras show it
  MapPicture shown_clouds_;  // clouds show it
  MapStatusWriter status_writer_;
  tf2_ros::TransformBroadcaster edges_;
  std::map<SessionId, Output> paths_;
  std::map<CloudPlace, Output> clouds_;
  Output apart_;
  bool shows_apart_ = false;  // whether there is anything to clear
  ros::Publisher cameras_, path_lines_, status_, pose_, keyframe_pose_;
};

}  // namespace rovio_sfm
