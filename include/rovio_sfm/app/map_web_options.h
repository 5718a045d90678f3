#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "rovio_sfm/app/robot_names.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// The private parameters of map_web.
struct MapWebOptions {
  std::vector<std::string> robots = {"rovio1"};
  std::string image = "image";
  std::string address = "127.0.0.1";
  int port = 8090;
  std::vector<std::string> hosts;
  bool allow_control = false;
  std::string token;
  int thumbnail_width_px = 320;
  double thumbnail_period_s = 0.5;

  void DescribeOptions(OptionTable& table) {
    AddRobotNames(table, robots, "whose cameras are shown");
    table.AddText(
        "image", image,
        "topic of each robot's pictures, in its namespace; …/compressed: CompressedImage");
    table.AddRule("image", !image.empty(), "the name of a topic");
    table.AddText("address", address, "IPv4 to listen on; 0.0.0.0 lets the network in");
    table.AddNumber("port", port, 0, 65535, "0 takes a free one; the log says which");
    table.AddTexts("hosts", hosts, "names of this machine by which browsers may call the page");
    table.AddFlag("allow_control", allow_control,
                  "buttons that finish, merge, unmerge and save, for who has the token");
    table.AddText("token", token, "of control; empty: a random one, logged at the start");
    table.AddRule("token", token.empty() || token.size() >= 16, "16 characters or more, or none");
    table.AddNumber("thumbnail_width_px", thumbnail_width_px, 16, 1920, "of the pictures shown");
    table.AddNumber("thumbnail_period_s", thumbnail_period_s, 0.0, 60.0,
                    "a robot's picture is made no oftener");
  }
};

// Reads the parameters and logs the effective ones, but for the token; throws std::runtime_error
// naming the first that does not fit.
MapWebOptions LoadMapWebOptions(const YAML::Node& parameters);

}  // namespace rovio_sfm
