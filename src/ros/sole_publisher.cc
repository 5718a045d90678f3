#include "rovio_sfm/ros/sole_publisher.h"

#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <algorithm>
#include <stdexcept>

namespace rovio_sfm {
namespace {

// A node that was killed stays registered: one that does not answer is none.
bool IsAlive(const std::string& node) {
  XmlRpc::XmlRpcValue request, response, uri;
  request[0] = ros::this_node::getName();
  request[1] = node;
  if (!ros::master::execute("lookupNode", request, response, uri, false)) return false;
  std::string host;
  uint32_t port = 0;
  if (!ros::network::splitURI(static_cast<std::string>(uri), host, port)) return false;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue caller, answer;
  caller[0] = ros::this_node::getName();
  return client.execute("getPid", caller, answer) && !client.isFault();
}

}  // namespace

void RequireSolePublisher(const ros::NodeHandle& handle, const std::vector<std::string>& topics) {
  XmlRpc::XmlRpcValue request, response, state;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getSystemState", request, response, state, true)) return;
  std::vector<std::string> names;
  for (const std::string& topic : topics) names.push_back(handle.resolveName(topic));
  XmlRpc::XmlRpcValue& publishers = state[0];  // [[topic, [node, …]], …]
  for (int i = 0; i < publishers.size(); ++i) {
    const std::string topic = publishers[i][0];
    if (std::find(names.begin(), names.end(), topic) == names.end()) continue;
    for (int k = 0; k < publishers[i][1].size(); ++k) {
      const std::string node = publishers[i][1][k];
      if (node == ros::this_node::getName()) break;  // the master lists them as they came
      if (!IsAlive(node)) continue;
      throw std::runtime_error(topic + " is published by " + node +
                               ": a robot has one driver; end the other or use another namespace");
    }
  }
}

}  // namespace rovio_sfm
