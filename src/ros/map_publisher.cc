#include "rovio_sfm/ros/map_publisher.h"

#include <geometry_msgs/PoseStamped.h>

#include <algorithm>
#include <set>

#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/map_frames.h"
#include "rovio_sfm/ros/map_messages.h"
#include "rovio_sfm/ros/topics.h"

namespace rovio_sfm {
namespace {

ros::Time NewestStamp(const MapSnapshot& snapshot) {
  int64_t newest_ns = 0;
  for (const SessionSnapshot& session : snapshot.sessions) {
    for (const auto& block : session.frames) {
      if (!block->empty()) newest_ns = std::max(newest_ns, block->back().stamp_ns);
    }
  }
  return ToTime(newest_ns);
}

}  // namespace

MapPublisher::MapPublisher(ros::NodeHandle node, double cloud_period_s)
    : node_(node), cloud_period_s_(cloud_period_s) {
  pose_ = node_.advertise<geometry_msgs::PoseStamped>(topics::kPose, topics::kPoseQueue);
  keyframe_pose_ =
      node_.advertise<geometry_msgs::PoseStamped>(topics::kKeyframePose, topics::kPoseQueue);
  OutputOf<sensor_msgs::PointCloud2>(topics::kCloud);
  OutputOf<visualization_msgs::MarkerArray>(topics::kCameras);
  OutputOf<MapStatus>(topics::kMapStatus);
}

template <typename Message>
MapPublisher::Output& MapPublisher::OutputOf(const std::string& topic) {
  Output& output = outputs_[topic];
  if (!output.publisher) {
    output.publisher = node_.advertise<Message>(topic, topics::kMapQueue, true);
  }
  return output;
}

bool MapPublisher::IsDue(Output* output, uint64_t version) const {
  if (output->version == version || output->publisher.getNumSubscribers() == 0) return false;
  output->version = version;
  return true;
}

void MapPublisher::PublishEdges(const MapPicture& picture) {
  const ros::Time now = ros::Time::now();
  if (now.isZero() || now == last_edges_) return;  // simulated time stands still: tf wants no twins
  last_edges_ = now;
  const auto edges = MapEdges(picture, now);
  if (!edges.empty()) edges_.sendTransform(edges);
}

void MapPublisher::PublishMap(const MapPicture& picture, const IngestCounters& counters,
                              bool is_final) {
  const ros::Time now = ros::Time::now();
  PublishStatus(picture, counters);
  PublishPaths(*picture.snapshot, now);
  PublishCameras(*picture.snapshot, now);
  PublishClouds(*picture.snapshot, now, is_final);
}

void MapPublisher::PublishPaths(const MapSnapshot& snapshot, const ros::Time& now) {
  for (const SessionSnapshot& session : snapshot.sessions) {
    Output& output =
        OutputOf<nav_msgs::Path>(topics::kPathPrefix + std::to_string(session.id.value));
    if (IsDue(&output, snapshot.version)) output.publisher.publish(PathMessage(session, now));
  }
}

void MapPublisher::PublishCameras(const MapSnapshot& snapshot, const ros::Time& now) {
  Output& output = OutputOf<visualization_msgs::MarkerArray>(topics::kCameras);
  if (IsDue(&output, snapshot.version)) output.publisher.publish(CameraMarkers(snapshot, now));
}

// The root map goes to `cloud`, every other to a topic and frame of its own: nobody knows yet where
// it lies.
void MapPublisher::PublishClouds(const MapSnapshot& snapshot, const ros::Time& now, bool is_final) {
  const ros::SteadyTime steady_now = ros::SteadyTime::now();
  if (!is_final && (steady_now - last_cloud_).toSec() < cloud_period_s_) return;
  last_cloud_ = steady_now;
  std::set<MapId> ids;
  for (const SessionSnapshot& session : snapshot.sessions) ids.insert(session.map);
  for (const MapId id : ids) {
    const bool is_root = id == *ids.begin();
    const std::string number = std::to_string(id.value);
    Output& output = OutputOf<sensor_msgs::PointCloud2>(is_root ? topics::kCloud
                                                                : topics::kCloudPrefix + number);
    if (!IsDue(&output, snapshot.version)) continue;
    if (const auto map = FindLevelMap(snapshot, id)) {
      const std::string frame = is_root ? MapFrame() : SessionFrame(map->sessions.front().id);
      output.publisher.publish(CloudMessage(*map, frame, now));
    }
  }
}

void MapPublisher::PublishStatus(const MapPicture& picture, const IngestCounters& counters) {
  Output& output = OutputOf<MapStatus>(topics::kMapStatus);
  if (output.version == picture.snapshot->version) return;  // latched: also when nobody listens
  output.version = picture.snapshot->version;
  MapStatus status;
  status.header.frame_id = MapFrame();
  status.header.stamp = NewestStamp(*picture.snapshot);
  status.sessions = SessionSummaries(*picture.snapshot);
  status.maps = MapSummaries(*picture.snapshot);
  status.num_events = static_cast<uint32_t>(picture.num_events);
  status.num_refused = static_cast<uint32_t>(counters.refused + picture.counters.refused_events);
  status.num_missing = static_cast<uint32_t>(picture.counters.missing_events);
  status.num_dropped = static_cast<uint32_t>(counters.dropped);
  output.publisher.publish(status);
}

void MapPublisher::PublishPose(const MapPicture& picture, SessionId id, uint32_t index) {
  for (const SessionSnapshot& session : picture.snapshot->sessions) {
    if (!(session.id == id)) continue;
    const FrameSnapshot* frame = FindFrame(session, index);
    const auto level_from_camera = frame == nullptr ? std::nullopt : CameraInLevel(session, *frame);
    if (!level_from_camera) return;
    geometry_msgs::PoseStamped pose;
    pose.header.frame_id = SessionFrame(id);
    pose.header.stamp = ToTime(frame->stamp_ns);
    pose.pose = ToPose(*level_from_camera);
    pose_.publish(pose);
    if (frame->kind == FrameKind::kKeyframe) keyframe_pose_.publish(pose);
  }
}

}  // namespace rovio_sfm
