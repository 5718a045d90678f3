#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// Where a frontend finds its camera. A name may be absolute or relative to the node's namespace;
// "guess" takes the only topic of its kind.
struct CameraTopicOptions {
  std::string image = "image_raw";
  std::string image_transport = "compressed";
  std::string camera_info = "camera_info";
  std::string odom = "odom";

  void DescribeOptions(OptionTable& table) {
    table.AddText("image", image, "base topic of the images, without /compressed; or guess");
    table.AddText("image_transport", image_transport,
                  "raw, compressed or another of image_transport; guess: compressed where it is");
    table.AddText("camera_info", camera_info, "topic of sensor_msgs/CameraInfo; or guess");
    table.AddText("odom", odom, "topic of nav_msgs/Odometry; guess; or none");
  }
};

inline constexpr char kGuessTopic[] = "guess";
inline constexpr char kNoTopic[] = "none";

// A topic that somebody publishes.
struct PublishedTopic {
  std::string name;
  std::string type;
};

struct ImageTopic {
  std::string base;
  std::string transport;
};

// What a guess is made of: all topics but `previews`, images that frontends themselves draw. Each
// is nothing while there is no such topic, and throws std::runtime_error that lists them where
// there are several.
std::optional<ImageTopic> GuessImageTopic(const std::vector<PublishedTopic>& topics,
                                          const std::vector<std::string>& previews,
                                          const std::string& transport);
// The one beside the images before any other.
std::optional<std::string> GuessCameraInfoTopic(const std::vector<PublishedTopic>& topics,
                                                const std::string& image_base);
std::optional<std::string> GuessOdometryTopic(const std::vector<PublishedTopic>& topics);

}  // namespace rovio_sfm
