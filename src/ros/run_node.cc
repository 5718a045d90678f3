#include "rovio_sfm/ros/run_node.h"

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <cstdio>
#include <exception>
#include <iostream>
#include <opencv2/core.hpp>

#include "rovio_sfm/ros/node_parameters.h"
#include "rovio_sfm/util/log.h"
#include "rovio_sfm/util/stop_signals.h"

namespace rovio_sfm {
namespace {

const ros::WallDuration kMasterPeriod(0.2);

void ToRosconsole(LogLevel level, const std::string& message) {
  switch (level) {
    case LogLevel::kDebug:
      ROS_DEBUG_STREAM(message);
      break;
    case LogLevel::kInfo:
      ROS_INFO_STREAM(message);
      break;
    case LogLevel::kWarning:
      ROS_WARN_STREAM(message);
      break;
    case LogLevel::kError:
      ROS_ERROR_STREAM(message);
      break;
  }
}

// roscpp's own wait knows no signal.
bool WaitForMaster() {
  bool has_told = false;
  while (!IsStopRequested()) {
    if (ros::master::check()) return true;
    if (!has_told) ROS_WARN_STREAM("waiting for the ROS master at " << ros::master::getURI());
    has_told = true;
    kMasterPeriod.sleep();
  }
  ROS_WARN("ended while waiting for the ROS master");
  return false;
}

// The outer handles keep rosconsole alive until what went wrong is told.
int RunBody(const NodeBody& body) {
  const ros::NodeHandle node, private_node("~");
  try {
    return body(node, private_node);
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
}

}  // namespace

int RunNode(int argc, char** argv, const std::string& name, const NodeBody& body) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // rosconsole read its own switch before main
  try {
    ros::init(argc, argv, name, ros::init_options::NoSigintHandler);
    CatchStopSignals();
    SetLogSink(ToRosconsole);
    cv::setNumThreads(1);
    return WaitForMaster() ? RunBody(body) : StatusOfStop();
  } catch (const std::exception& error) {  // a name or a remapping that ROS does not bear
    std::cerr << name << ": " << error.what() << "\n";
    return 1;
  }
}

YAML::Node ParametersOf(const ros::NodeHandle& private_node) {
  XmlRpc::XmlRpcValue parameters;
  const bool has_any = private_node.getParam(private_node.getNamespace(), parameters);
  return has_any ? ToYaml(parameters) : YAML::Node(YAML::NodeType::Map);
}

void SpinUntilStopped(const std::function<void()>& tick) {
  const ros::WallDuration longest_wait(0.1);
  while (!IsStopRequested() && ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable(longest_wait);
    if (tick) tick();
  }
}

}  // namespace rovio_sfm
