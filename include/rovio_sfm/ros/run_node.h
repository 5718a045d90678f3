#pragma once

#include <ros/node_handle.h>
#include <yaml-cpp/yaml.h>

#include <functional>
#include <string>

namespace rovio_sfm {

// Starts the ROS side of a program: core messages go to rosconsole, SIGINT and SIGTERM ask it to
// end (the publishers live on until the program says so), OpenCV keeps to the threads that call it.
void InitNode(int argc, char** argv, const std::string& name);

// All private parameters of the node; an empty group where there are none.
YAML::Node ParametersOf(const ros::NodeHandle& private_node);

// Handles callbacks on this thread until SIGINT, SIGTERM or a shutdown by the master, calling
// `tick` at least every 100 ms of wall time.
void SpinUntilStopped(const std::function<void()>& tick = nullptr);

}  // namespace rovio_sfm
