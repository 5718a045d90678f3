#include "rovio_sfm/ros/waiting_hints.h"

#include <ros/ros.h>

#include <algorithm>

#include "rovio_sfm/ros/topics.h"

namespace rovio_sfm {
namespace {

constexpr double kFirstAfterS = 5.0;
constexpr double kPeriodS = 30.0;

// What others publish; the node's own previews are no answer.
std::vector<std::string> TopicsOfTypes(const std::set<std::string>& types) {
  ros::master::V_TopicInfo topics;
  ros::V_string own;
  std::vector<std::string> names;
  if (!ros::master::getTopics(topics)) return names;
  ros::this_node::getAdvertisedTopics(own);
  for (const ros::master::TopicInfo& topic : topics) {
    const bool is_own = std::find(own.begin(), own.end(), topic.name) != own.end();
    if (types.count(topic.datatype) > 0 && !is_own) names.push_back(topic.name);
  }
  return names;
}

}  // namespace

std::vector<AwaitedTopic> AwaitedFrames(const std::vector<std::string>& robots) {
  std::vector<AwaitedTopic> awaited;
  for (const std::string& robot : robots) {
    awaited.push_back({"frames", "/" + robot + "/" + topics::kFrames, {"rovio_sfm/FrameEventMsg"}});
  }
  return awaited;
}

void WaitingHints::Look(const std::vector<AwaitedTopic>& awaited, double now_s) {
  if (next_s_ == 0.0) next_s_ = now_s + kFirstAfterS;
  if (now_s < next_s_) return;
  next_s_ = now_s + kPeriodS;
  if (ros::Time::isSimTime() && ros::Time::now().isZero()) {
    ROS_WARN("/use_sim_time is set, but nobody publishes /clock: no time passes for this node");
  }
  for (const AwaitedTopic& topic : awaited) {
    ROS_WARN_STREAM(Describe(topic, TopicsOfTypes(topic.types)));
  }
}

std::string Describe(const AwaitedTopic& awaited, const std::vector<std::string>& others) {
  std::string list;
  for (const std::string& other : others) list += (list.empty() ? "" : ", ") + other;
  return "no " + awaited.what + " on " + awaited.topic +
         " yet; topics of that type: " + (list.empty() ? "none" : list);
}

}  // namespace rovio_sfm
