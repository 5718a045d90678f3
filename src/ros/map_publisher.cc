#include "rovio_sfm/ros/map_publisher.h"

#include <geometry_msgs/PoseStamped.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "rovio_sfm/report/level_session.h"
#include "rovio_sfm/ros/camera_markers.h"
#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/map_frames.h"
#include "rovio_sfm/ros/map_messages.h"
#include "rovio_sfm/ros/topics.h"

namespace rovio_sfm {
namespace {

std::string TopicOfCloudApart(MapId id) { return topics::kCloudPrefix + std::to_string(id.value); }

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

// Whether a session's gauge is another than at the last call.
bool MapPublisher::TakeGauges(const MapSnapshot& snapshot) {
  std::vector<Gauge> gauges;
  for (const SessionSnapshot& session : snapshot.sessions) {
    const double metres_per_unit = session.scale ? session.scale->metres_per_unit : 0.0;
    gauges.push_back({session.id, session.map, session.gauge_revision, metres_per_unit});
  }
  const auto is_same = [](const Gauge& a, const Gauge& b) {
    return std::tie(a.session, a.map, a.revision, a.metres_per_unit) ==
           std::tie(b.session, b.map, b.revision, b.metres_per_unit);
  };
  const std::vector<Gauge> last = std::exchange(gauges_, gauges);
  return !std::equal(last.begin(), last.end(), gauges.begin(), gauges.end(), is_same);
}

void MapPublisher::PublishEdges(const MapPicture& picture, const IngestCounters& counters) {
  const ros::Time now = ros::Time::now();
  if (now.isZero() || now == last_edges_) return;  // simulated time stands still: tf wants no twins
  last_edges_ = now;
  const auto edges = MapEdges(picture, now);
  if (!edges.empty()) edges_.sendTransform(edges);
  if (TakeGauges(*picture.snapshot)) PublishMap(picture, counters, true);
}

void MapPublisher::PublishMap(const MapPicture& picture, const IngestCounters& counters,
                              bool at_once) {
  const ros::Time now = ros::Time::now();
  PublishStatus(picture, counters);
  PublishPaths(*picture.snapshot, now);
  PublishCameras(picture, now);
  const ros::SteadyTime steady_now = ros::SteadyTime::now();
  if (!at_once && (steady_now - last_cloud_).toSec() < cloud_period_s_) return;
  last_cloud_ = steady_now;
  PublishClouds(*picture.snapshot, now);
}

void MapPublisher::PublishPaths(const MapSnapshot& snapshot, const ros::Time& now) {
  for (const SessionSnapshot& session : snapshot.sessions) {
    Output& output =
        OutputOf<nav_msgs::Path>(topics::kPathPrefix + std::to_string(session.id.value));
    if (IsDue(&output, snapshot.version)) output.publisher.publish(PathMessage(session, now));
  }
}

void MapPublisher::PublishCameras(const MapPicture& picture, const ros::Time& now) {
  Output& output = OutputOf<visualization_msgs::MarkerArray>(topics::kCameras);
  if (!IsDue(&output, picture.snapshot->version)) return;
  output.publisher.publish(CameraMarkers(*picture.snapshot, picture.merges, now));
}

// The root map goes to `cloud`, every other to a topic and frame of its own, which is cleared when
// the map has joined another.
void MapPublisher::PublishClouds(const MapSnapshot& snapshot, const ros::Time& now) {
  const SessionSnapshot* root = FindRoot(snapshot);
  if (root != nullptr) PublishCloud(snapshot, root->map, topics::kCloud, now);
  std::set<MapId> apart;
  for (const SessionSnapshot& session : snapshot.sessions) {
    if (root == nullptr || !(session.map == root->map)) apart.insert(session.map);
  }
  const std::set<MapId> last = std::exchange(apart_, apart);
  for (const MapId id : apart) {
    PublishCloud(snapshot, id, TopicOfCloudApart(id), now);
  }
  for (const MapId id : last) {
    if (apart.count(id) > 0) continue;
    sensor_msgs::PointCloud2 nothing;
    nothing.header.frame_id = SessionFrame(SessionId{id.value});
    nothing.header.stamp = now;
    OutputOf<sensor_msgs::PointCloud2>(TopicOfCloudApart(id)).publisher.publish(nothing);
  }
}

void MapPublisher::PublishCloud(const MapSnapshot& snapshot, MapId id, const std::string& topic,
                                const ros::Time& now) {
  Output& output = OutputOf<sensor_msgs::PointCloud2>(topic);
  if (!IsDue(&output, snapshot.version)) return;
  const std::optional<LevelMap> map = FindLevelMap(snapshot, id);
  if (!map) return;
  const std::string frame =
      topic == topics::kCloud ? MapFrame() : SessionFrame(map->sessions.front().id);
  output.publisher.publish(CloudMessage(*map, frame, now));
}

void MapPublisher::PublishStatus(const MapPicture& picture, const IngestCounters& counters) {
  Output& output = OutputOf<MapStatus>(topics::kMapStatus);
  if (output.version == picture.snapshot->version) return;  // latched: also when nobody listens
  output.version = picture.snapshot->version;
  output.publisher.publish(ToMessage(picture, counters));
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
