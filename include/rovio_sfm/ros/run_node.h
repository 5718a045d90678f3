#pragma once

#include <ros/node_handle.h>
#include <yaml-cpp/yaml.h>

#include <functional>
#include <string>

namespace rovio_sfm {

// What a node does between its start and its end; the exit status.
using NodeBody = std::function<int(ros::NodeHandle node, ros::NodeHandle private_node)>;

// Runs a node as a program: waits for the master, says so, and ends there at SIGINT or SIGTERM;
// core messages go to rosconsole, which writes each line at once, into a file too; OpenCV keeps to
// the threads that call it. What the body throws is told on the terminal and in /rosout, exit
// status 1. `stop_signals.h` says what signals do; publishers live on until the body returns.
int RunNode(int argc, char** argv, const std::string& name, const NodeBody& body);

// All private parameters of the node; an empty group where there are none.
YAML::Node ParametersOf(const ros::NodeHandle& private_node);

// Handles callbacks on this thread until SIGINT, SIGTERM or a shutdown by the master, calling
// `tick` at least every 100 ms of wall time.
void SpinUntilStopped(const std::function<void()>& tick = nullptr);

}  // namespace rovio_sfm
