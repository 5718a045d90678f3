#include "rovio_sfm/ros/camera_subscribers.h"

#include <rovio_sfm/FrameEventMsg.h>

#include <string>
#include <utility>
#include <vector>

#include "rovio_sfm/ros/topics.h"

namespace rovio_sfm {
namespace {

constexpr double kSearchPeriodS = 1.0;
constexpr double kWarnPeriodS = 10.0;
constexpr char kCompressed[] = "compressed";

std::vector<PublishedTopic> PublishedTopics() {
  ros::master::V_TopicInfo found;
  ros::master::getTopics(found);
  std::vector<PublishedTopic> topics;
  for (const ros::master::TopicInfo& topic : found) topics.push_back({topic.name, topic.datatype});
  return topics;
}

// The images that frontends draw, each beside its frames.
std::vector<std::string> PreviewsOf(const std::vector<PublishedTopic>& published) {
  std::vector<std::string> previews;
  for (const PublishedTopic& topic : published) {
    if (topic.type != ros::message_traits::DataType<FrameEventMsg>::value()) continue;
    const std::string space = topic.name.substr(0, topic.name.rfind('/') + 1);
    previews.push_back(space + topics::kPreview);
    previews.push_back(space + topics::kDebugMatches);
  }
  return previews;
}

}  // namespace

CameraSubscribers::CameraSubscribers(const CameraTopicOptions& options, bool needs_camera_info,
                                     ros::NodeHandle node, CameraCallbacks callbacks)
    : options_(options),
      needs_camera_info_(needs_camera_info),
      node_(node),
      callbacks_(std::move(callbacks)),
      transports_(node) {
  if (options_.image_transport == kGuessTopic && options_.image != kGuessTopic) {
    options_.image_transport = kCompressed;
  }
  if (options_.image != kGuessTopic) SubscribeImages({options_.image, options_.image_transport});
  if (options_.camera_info != kGuessTopic) SubscribeCameraInfo(options_.camera_info);
  if (options_.odom != kGuessTopic) SubscribeOdometry(options_.odom);
}

void CameraSubscribers::SubscribeImages(const ImageTopic& topic) {
  image_base_ = node_.resolveName(topic.base);
  ROS_INFO_STREAM("images: " << *image_base_ << ", transport " << topic.transport);
  if (topic.transport == kCompressed) {
    compressed_ = node_.subscribe<sensor_msgs::CompressedImage>(
        *image_base_ + "/" + kCompressed, topics::kImageQueue, callbacks_.on_compressed);
    return;
  }
  images_ = transports_.subscribe(*image_base_, topics::kImageQueue, callbacks_.on_image,
                                  ros::VoidPtr(), image_transport::TransportHints(topic.transport));
}

void CameraSubscribers::SubscribeCameraInfo(const std::string& name) {
  if (!needs_camera_info_) return;
  ROS_INFO_STREAM("camera_info: " << node_.resolveName(name));
  camera_info_ = node_.subscribe<sensor_msgs::CameraInfo>(name, topics::kCameraInfoQueue,
                                                          callbacks_.on_camera_info);
}

void CameraSubscribers::SubscribeOdometry(const std::string& name) {
  if (name == kNoTopic) return;
  ROS_INFO_STREAM("odometry: " << node_.resolveName(name));
  odom_ = node_.subscribe<nav_msgs::Odometry>(name, topics::kOdomQueue, callbacks_.on_odometry);
}

uint32_t CameraSubscribers::NumImagePublishers() const {
  return compressed_ ? compressed_.getNumPublishers() : images_.getNumPublishers();
}

bool CameraSubscribers::IsComplete() const {
  return image_base_ && (camera_info_ || !needs_camera_info_) &&
         (odom_ || options_.odom == kNoTopic);
}

void CameraSubscribers::Search() {
  const ros::SteadyTime now = ros::SteadyTime::now();
  if (IsComplete() || (now - last_search_).toSec() < kSearchPeriodS) return;
  last_search_ = now;
  const std::vector<PublishedTopic> topics = PublishedTopics();
  if (!image_base_) {
    const auto image = GuessImageTopic(topics, PreviewsOf(topics), options_.image_transport);
    if (image) SubscribeImages(*image);
  }
  if (!image_base_) {
    ROS_WARN_THROTTLE(kWarnPeriodS,
                      "waiting for images: no topic of type sensor_msgs/Image or "
                      "CompressedImage is published");
    return;
  }
  if (!camera_info_ && needs_camera_info_) {
    const auto info = GuessCameraInfoTopic(topics, *image_base_);
    if (info) SubscribeCameraInfo(*info);
    if (!info) {
      ROS_WARN_THROTTLE(kWarnPeriodS,
                        "waiting for the calibration: no topic of type "
                        "sensor_msgs/CameraInfo is published; a file does instead: "
                        "calibration:=FILE");
    }
  }
  if (!odom_ && options_.odom == kGuessTopic) {
    if (const auto odom = GuessOdometryTopic(topics)) SubscribeOdometry(*odom);
  }
}

}  // namespace rovio_sfm
