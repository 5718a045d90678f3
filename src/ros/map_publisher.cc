#include "rovio_sfm/ros/map_publisher.h"

#include <geometry_msgs/PoseStamped.h>

#include <optional>
#include <set>
#include <utility>

#include "rovio_sfm/report/level_session.h"
#include "rovio_sfm/ros/apart_markers.h"
#include "rovio_sfm/ros/camera_markers.h"
#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/map_frames.h"
#include "rovio_sfm/ros/map_messages.h"
#include "rovio_sfm/ros/path_markers.h"
#include "rovio_sfm/ros/topics.h"

namespace rovio_sfm {
namespace {

constexpr bool kLatched = true;
constexpr CloudPlace kRootCloud = {true, {}};

std::string TopicOf(const CloudPlace& place) {
  return place.is_root ? topics::kCloud : topics::kCloudPrefix + std::to_string(place.map.value);
}

size_t CountMaps(const MapSnapshot& snapshot) {
  std::set<MapId> maps;
  for (const SessionSnapshot& session : snapshot.sessions) maps.insert(session.map);
  return maps.size();
}

}  // namespace

MapPublisher::MapPublisher(ros::NodeHandle node, double cloud_period_s)
    : node_(node), cloud_period_s_(cloud_period_s) {
  shown_.snapshot = shown_clouds_.snapshot = std::make_shared<const MapSnapshot>();
  pose_ = node_.advertise<geometry_msgs::PoseStamped>(topics::kPose, topics::kPoseQueue);
  keyframe_pose_ =
      node_.advertise<geometry_msgs::PoseStamped>(topics::kKeyframePose, topics::kPoseQueue);
  status_ = node_.advertise<MapStatus>(topics::kMapStatus, topics::kMapQueue, kLatched);
  AdvertiseMarkers();
  CloudOutput(kRootCloud);
}

void MapPublisher::AdvertiseMarkers() {
  cameras_ = node_.advertise<visualization_msgs::MarkerArray>(
      topics::kCameras, topics::kMarkersQueue,
      [this](const ros::SingleSubscriberPublisher& listener) {
        listener.publish(CameraMarkers(*shown_.snapshot, *shown_.merges, ros::Time::now()));
      });
  path_lines_ = node_.advertise<visualization_msgs::MarkerArray>(
      topics::kPaths, topics::kMarkersQueue,
      [this](const ros::SingleSubscriberPublisher& listener) {
        listener.publish(PathMarkers(*shown_.snapshot, ros::Time::now()));
      });
  Advertise<visualization_msgs::MarkerArray>(
      topics::kMapsApart,
      [this] { return ApartMarkers(*shown_clouds_.snapshot, ros::Time::now()); }, &apart_);
}

// A new listener is sent the message that is latched, and the newest where that is another.
template <typename Message>
void MapPublisher::Advertise(const std::string& topic, std::function<Message()> newest,
                             Output* output) {
  const auto refresh = [this, newest = std::move(newest),
                        output](const ros::SingleSubscriberPublisher&) {
    if (output->is_stale) Send(newest, output);
  };
  output->publisher =
      node_.advertise<Message>(topic, topics::kMapQueue, refresh, ros::SubscriberStatusCallback(),
                               ros::VoidConstPtr(), kLatched);
}

// Makes the message only if somebody listens.
template <typename Message>
void MapPublisher::Send(const std::function<Message()>& newest, Output* output) {
  output->is_stale = output->publisher.getNumSubscribers() == 0;
  if (!output->is_stale) output->publisher.publish(newest());
}

MapPublisher::Output& MapPublisher::PathOutput(SessionId id) {
  Output& output = paths_[id];
  if (!output.publisher) {
    Advertise<nav_msgs::Path>(
        topics::kPathPrefix + std::to_string(id.value), [this, id] { return NewestPath(id); },
        &output);
  }
  return output;
}

MapPublisher::Output& MapPublisher::CloudOutput(const CloudPlace& place) {
  Output& output = clouds_[place];
  if (!output.publisher) {
    Advertise<sensor_msgs::PointCloud2>(
        TopicOf(place), [this, place] { return NewestCloud(place); }, &output);
  }
  return output;
}

// Empty for a session that is gone.
nav_msgs::Path MapPublisher::NewestPath(SessionId id) const {
  const SessionSnapshot* session = FindSession(*shown_.snapshot, id);
  SessionSnapshot nothing;
  nothing.id = id;
  return PathMessage(session == nullptr ? nothing : *session, ros::Time::now());
}

// Empty where no map is shown.
sensor_msgs::PointCloud2 MapPublisher::NewestCloud(const CloudPlace& place) const {
  const MapSnapshot& snapshot = *shown_clouds_.snapshot;
  const SessionSnapshot* root = FindRoot(snapshot);
  std::optional<LevelMap> map;
  if (root != nullptr && place.is_root) map = FindLevelMap(snapshot, root->map);
  if (root != nullptr && !place.is_root && !(root->map == place.map)) {
    map = FindLevelMap(snapshot, place.map);
  }
  const SessionId first = map ? map->sessions.front().id : SessionId{place.map.value};
  return CloudMessage(map.value_or(LevelMap()), place.is_root ? MapFrame() : SessionFrame(first),
                      ros::Time::now());
}

void MapPublisher::PublishEdges(const MapPicture& picture, const IngestCounters& counters) {
  const ros::Time now = ros::Time::now();
  if (now.isZero() || now == last_edges_) return;  // simulated time stands still: tf wants no twins
  last_edges_ = now;
  const auto edges = MapEdges(picture, now);
  if (!edges.empty()) edges_.sendTransform(edges);
  if (parts_.TakeGauges(picture)) PublishMap(picture, counters, true);
}

void MapPublisher::PublishMap(const MapPicture& picture, const IngestCounters& counters,
                              bool at_once) {
  if (const auto status = status_writer_.Write(picture, counters)) status_.publish(*status);
  PublishSessions(picture);
  const ros::SteadyTime now = ros::SteadyTime::now();
  if (!at_once && (now - last_cloud_).toSec() < cloud_period_s_) return;
  last_cloud_ = now;
  PublishClouds(picture);
}

// What changed is taken though nobody may listen: `shown_` is what all listeners of the cameras
// have.
void MapPublisher::PublishSessions(const MapPicture& picture) {
  const SessionChanges changes = parts_.TakeSessions(picture);
  shown_ = picture;
  for (const auto& ids : {changes.gone, changes.sessions}) {
    for (const SessionId id : ids) {
      Send<nav_msgs::Path>([this, id] { return NewestPath(id); }, &PathOutput(id));
    }
  }
  if (path_lines_.getNumSubscribers() > 0) {
    const auto lines = ChangedPathMarkers(*picture.snapshot, changes, ros::Time::now());
    if (!lines.markers.empty()) path_lines_.publish(lines);
  }
  if (cameras_.getNumSubscribers() == 0) return;
  const auto markers =
      ChangedCameraMarkers(*picture.snapshot, *picture.merges, changes, ros::Time::now());
  if (!markers.markers.empty()) cameras_.publish(markers);
}

// The root map goes to `cloud`, every other to a topic and frame of its own, which is cleared when
// the map has joined another.
void MapPublisher::PublishClouds(const MapPicture& picture) {
  const CloudChanges changes = parts_.TakeClouds(picture);
  shown_clouds_ = picture;
  for (const auto& places : {changes.gone, changes.clouds}) {
    for (const CloudPlace& place : places) {
      Send<sensor_msgs::PointCloud2>([this, place] { return NewestCloud(place); },
                                     &CloudOutput(place));
    }
  }
  const bool has_changed = !changes.clouds.empty() || !changes.gone.empty();
  const bool is_apart = CountMaps(*picture.snapshot) > 1;
  if (has_changed && (is_apart || shows_apart_)) {
    Send<visualization_msgs::MarkerArray>(
        [this] { return ApartMarkers(*shown_clouds_.snapshot, ros::Time::now()); }, &apart_);
  }
  shows_apart_ = is_apart;
}

void MapPublisher::PublishPose(const MapPicture& picture, SessionId id, uint32_t index) {
  const SessionSnapshot* session = FindSession(*picture.snapshot, id);
  const FrameSnapshot* frame = session == nullptr ? nullptr : FindFrame(*session, index);
  if (frame != nullptr) PublishPose(*session, *frame);
}

void MapPublisher::PublishPose(const MapPicture& picture, const Localization& localization) {
  const SessionSnapshot* session = FindSession(*picture.snapshot, localization.session);
  if (session != nullptr) PublishPose(*session, FrameOf(localization));
}

void MapPublisher::PublishPose(const SessionSnapshot& session, const FrameSnapshot& frame) {
  const std::optional<Rigid3> level_from_camera = CameraInLevel(session, frame);
  if (!level_from_camera) return;
  geometry_msgs::PoseStamped pose;
  pose.header.frame_id = SessionFrame(session.id);
  pose.header.stamp = ToTime(frame.stamp_ns);
  pose.pose = ToPose(*level_from_camera);
  pose_.publish(pose);
  if (frame.kind == FrameKind::kKeyframe) keyframe_pose_.publish(pose);
}

}  // namespace rovio_sfm
