#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include "rovio_sfm/ros/map_frames.h"
#include "rovio_sfm/ros/run_node.h"
#include "rovio_sfm/ros/topics.h"

// Hands on /tf, from "in" to "out", without the edges that a mapper publishes: what a bag records,
// or what is taken out of one that holds them.
int main(int argc, char** argv) {
  return rovio_sfm::RunNode(argc, argv, "tf_inputs", [](ros::NodeHandle node, ros::NodeHandle) {
    const ros::Publisher out =
        node.advertise<tf2_msgs::TFMessage>("out", rovio_sfm::topics::kTfQueue);
    const auto hand_on = [&](const tf2_msgs::TFMessageConstPtr& message) {
      const tf2_msgs::TFMessage inputs = rovio_sfm::WithoutMapEdges(*message);
      if (inputs.transforms.size() < message->transforms.size()) {
        ROS_INFO_ONCE("the transforms of a mapper on %s are left out",
                      node.resolveName("in").c_str());
      }
      if (!inputs.transforms.empty()) out.publish(inputs);
    };
    const ros::Subscriber in = node.subscribe<tf2_msgs::TFMessage>(
        "in", rovio_sfm::topics::kTfQueue, hand_on, {}, ros::TransportHints().tcpNoDelay());
    rovio_sfm::SpinUntilStopped();
    return 0;
  });
}
