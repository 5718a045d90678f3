#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/ros.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <atomic>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "rovio_sfm/app/live_parts.h"
#include "rovio_sfm/app/map_web_options.h"
#include "rovio_sfm/app/web_router.h"
#include "rovio_sfm/ros/image_bytes.h"
#include "rovio_sfm/ros/mapping_control.h"
#include "rovio_sfm/ros/web_server.h"

namespace rovio_sfm {

// The map as a web page that grows with it. The callbacks, on one thread, keep the newest of what
// mapping and the cameras say; the server's threads hand it out. All but map_status is listened to
// only while somebody looks, so that an idle page costs mapping nothing.
class MapWebNode {
 public:
  // secret: random text, of which the token is made where the options name none.
  // Throws std::runtime_error where the page or the port cannot be had.
  MapWebNode(const MapWebOptions& options, const std::string& secret, ros::NodeHandle node);
  ~MapWebNode();

  // Call at least once a second.
  void Tick();

 private:
  void Subscribe();
  void SubscribeMap();
  void SubscribeCamera(const std::string& robot);
  void TakeCloud(const sensor_msgs::PointCloud2& cloud);
  void TakeMarkers(const std::string& group, const visualization_msgs::MarkerArray& markers);
  void TakeEdges(const tf2_msgs::TFMessage& edges);
  void TakePose(const geometry_msgs::PoseStamped& pose);
  template <typename Image>
  void TakeImage(const std::string& robot, const Image& message);

  const MapWebOptions options_;
  ros::NodeHandle node_;
  LiveParts parts_;
  MappingControl control_;
  WebRouter router_;
  std::atomic<uint64_t> num_requests_{0};
  uint64_t num_requests_seen_ = 0;
  ros::SteadyTime last_request_;
  std::map<std::string, ros::SteadyTime> last_thumbnail_;
  ros::Subscriber status_subscriber_;
  std::vector<ros::Subscriber> subscribers_;  // of what is listened to while somebody looks
  WebServer server_;                          // its threads use the others
};

}  // namespace rovio_sfm
