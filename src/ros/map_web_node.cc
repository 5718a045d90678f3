#include "rovio_sfm/ros/map_web_node.h"

#include <rovio_sfm/MapStatus.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "rovio_sfm/app/thumbnail.h"
#include "rovio_sfm/app/write_page.h"
#include "rovio_sfm/ros/live_messages.h"
#include "rovio_sfm/ros/live_status.h"
#include "rovio_sfm/ros/map_frames.h"
#include "rovio_sfm/ros/topics.h"
#include "rovio_sfm/util/text_ends.h"

namespace rovio_sfm {
namespace {

using visualization_msgs::Marker;

constexpr double kAttentionS = 10.0;  // so long after its last request nobody looks any more
constexpr double kWarnPeriodS = 10.0;
constexpr char kTf[] = "/tf";

WebSite SiteOf(const MapWebOptions& options, const std::string& secret) {
  WebSite site;
  site.policy.hosts = options.hosts;
  site.policy.allow_control = options.allow_control;
  site.policy.token = options.token.empty() ? secret : options.token;
  site.robots = options.robots;
  site.instance = std::to_string(std::hash<std::string>()(secret) % 100'000'000);
  const nlohmann::ordered_json settings = {
      {"live", true}, {"robots", options.robots}, {"control", options.allow_control}};
  site.page = LivePageText(settings.dump());
  return site;
}

}  // namespace

MapWebNode::MapWebNode(const MapWebOptions& options, const std::string& secret,
                       ros::NodeHandle node)
    : options_(options),
      node_(node),
      control_(node),
      router_(SiteOf(options, secret), &parts_,
              [this](const ControlOrder& order) { return control_.Call(order); }),
      status_subscriber_(node_.subscribe<MapStatus>(
          topics::kMapStatus, topics::kMapQueue,
          [this](const MapStatusConstPtr& status) { parts_.Set("status", LiveStatus(*status)); })),
      server_(options.address, options.port, [this](const WebRequest& request) {
        ++num_requests_;
        return router_.Answer(request);
      }) {
  const std::string host = options.address == "0.0.0.0" ? "localhost" : options.address;
  const std::string url = "http://" + host + ":" + std::to_string(server_.port()) + "/";
  const std::string token = options.token.empty() ? secret : options.token;
  ROS_INFO_STREAM("the map is shown at " << url);
  if (options.allow_control) ROS_INFO_STREAM("to control it: " << url << "#token=" << token);
}

MapWebNode::~MapWebNode() {
  control_.Stop();
  server_.Stop();
}

void MapWebNode::Tick() {
  parts_.Set("scene/mapping", status_subscriber_.getNumPublishers() > 0 ? "true" : "false");
  const ros::SteadyTime now = ros::SteadyTime::now();
  const uint64_t num_requests = num_requests_;
  if (num_requests != num_requests_seen_) last_request_ = now;
  num_requests_seen_ = num_requests;
  const bool is_watched = num_requests_seen_ > 0 && (now - last_request_).toSec() < kAttentionS;
  if (is_watched && subscribers_.empty()) Subscribe();
  if (!is_watched) subscribers_.clear();
}

void MapWebNode::Subscribe() {
  SubscribeMap();
  for (const std::string& robot : options_.robots) SubscribeCamera(robot);
}

void MapWebNode::SubscribeMap() {
  using visualization_msgs::MarkerArray;
  const auto take_markers = [this](const char* topic, uint32_t queue) {
    subscribers_.push_back(node_.subscribe<MarkerArray>(
        topic, queue, [this, topic](const visualization_msgs::MarkerArrayConstPtr& markers) {
          TakeMarkers(topic, *markers);
        }));
  };
  take_markers(topics::kCameras, topics::kMarkersQueue);
  take_markers(topics::kPaths, topics::kMarkersQueue);
  subscribers_.push_back(
      node_.subscribe<MarkerArray>(topics::kMapsApart, topics::kMapQueue,
                                   [this](const visualization_msgs::MarkerArrayConstPtr& markers) {
                                     parts_.Set("scene/apart", LiveShapes(*markers));
                                   }));
  subscribers_.push_back(
      node_.subscribe(topics::kCloud, topics::kMapQueue, &MapWebNode::TakeCloud, this));
  subscribers_.push_back(
      node_.subscribe(topics::kPose, topics::kPoseQueue, &MapWebNode::TakePose, this));
  subscribers_.push_back(node_.subscribe(kTf, topics::kTfQueue, &MapWebNode::TakeEdges, this));
}

void MapWebNode::SubscribeCamera(const std::string& robot) {
  const std::string topic = "/" + robot + "/" + options_.image;
  if (EndsWith(topic, "/compressed")) {
    subscribers_.push_back(node_.subscribe<sensor_msgs::CompressedImage>(
        topic, topics::kPreviewQueue,
        [this, robot](const sensor_msgs::CompressedImageConstPtr& image) {
          TakeImage(robot, *image);
        }));
    return;
  }
  subscribers_.push_back(node_.subscribe<sensor_msgs::Image>(
      topic, topics::kPreviewQueue,
      [this, robot](const sensor_msgs::ImageConstPtr& image) { TakeImage(robot, *image); }));
}

void MapWebNode::TakeCloud(const sensor_msgs::PointCloud2& cloud) {
  std::string error;
  auto bytes = LiveCloud(cloud, &error);
  if (bytes) return parts_.Set("cloud", std::move(*bytes));
  ROS_WARN_STREAM_THROTTLE(kWarnPeriodS, "not shown: " << error);
}

// Of one topic: at first all, behind a marker that clears, then what changes.
void MapWebNode::TakeMarkers(const std::string& group,
                             const visualization_msgs::MarkerArray& markers) {
  const std::string prefix = "scene/" + group + "/";
  for (const Marker& marker : markers.markers) {
    if (marker.action == Marker::DELETEALL) parts_.EraseAll(prefix);
    if (marker.action == Marker::DELETE) parts_.Erase(prefix + marker.ns);
    if (marker.action == Marker::ADD) parts_.Set(prefix + marker.ns, LiveLines(marker));
  }
}

void MapWebNode::TakeEdges(const tf2_msgs::TFMessage& edges) {
  for (const geometry_msgs::TransformStamped& edge : edges.transforms) {
    const auto session = SessionOfFrame(edge.child_frame_id);
    if (!session || edge.header.frame_id != MapFrame()) continue;
    parts_.Set("scene/place/" + std::to_string(*session), LivePose(edge.transform));
  }
}

void MapWebNode::TakePose(const geometry_msgs::PoseStamped& pose) {
  const auto session = SessionOfFrame(pose.header.frame_id);
  if (session) parts_.Set("scene/pose/" + std::to_string(*session), LivePose(pose.pose));
}

template <typename Image>
void MapWebNode::TakeImage(const std::string& robot, const Image& message) {
  const ros::SteadyTime now = ros::SteadyTime::now();
  const auto last = last_thumbnail_.find(robot);
  const bool is_early =
      last != last_thumbnail_.end() && (now - last->second).toSec() < options_.thumbnail_period_s;
  if (is_early) return;
  last_thumbnail_[robot] = now;
  std::string error;
  const ImageBytes bytes = BytesOf(message, &error);
  auto jpeg =
      bytes == nullptr ? std::nullopt : ThumbnailOf(*bytes, options_.thumbnail_width_px, &error);
  if (jpeg) return parts_.Set("camera/" + robot, std::move(*jpeg));
  ROS_WARN_STREAM_THROTTLE(kWarnPeriodS, robot << ": picture not shown: " << error);
}

}  // namespace rovio_sfm
