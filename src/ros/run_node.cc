#include "rovio_sfm/ros/run_node.h"

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <csignal>
#include <opencv2/core.hpp>

#include "rovio_sfm/ros/node_parameters.h"
#include "rovio_sfm/util/log.h"

namespace rovio_sfm {
namespace {

volatile std::sig_atomic_t stop_requested = 0;  // the only thing a signal handler may write

void RequestStop(int) { stop_requested = 1; }

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

}  // namespace

void InitNode(int argc, char** argv, const std::string& name) {
  ros::init(argc, argv, name, ros::init_options::NoSigintHandler);
  std::signal(SIGINT, RequestStop);
  std::signal(SIGTERM, RequestStop);
  SetLogSink(ToRosconsole);
  cv::setNumThreads(1);
}

YAML::Node ParametersOf(const ros::NodeHandle& private_node) {
  XmlRpc::XmlRpcValue parameters;
  const bool has_any = private_node.getParam(private_node.getNamespace(), parameters);
  return has_any ? ToYaml(parameters) : YAML::Node(YAML::NodeType::Map);
}

void SpinUntilStopped(const std::function<void()>& tick) {
  const ros::WallDuration longest_wait(0.1);
  while (stop_requested == 0 && ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable(longest_wait);
    if (tick) tick();
  }
}

}  // namespace rovio_sfm
