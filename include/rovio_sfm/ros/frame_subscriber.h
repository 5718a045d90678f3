#pragma once

#include <ros/ros.h>
#include <rovio_sfm/FrameEventMsg.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "rovio_sfm/scene/events.h"

namespace rovio_sfm {

// Listens to /<robot>/frames of all robots. Malformed events, and events on another robot's topic,
// are refused, counted and warned of; the others are handed on, in the spinning thread.
class FrameSubscriber {
 public:
  using Handler = std::function<void(const FrameEventMsg::ConstPtr&, FrameEvent)>;

  FrameSubscriber(ros::NodeHandle node, const std::vector<std::string>& robots, Handler handler);

  // Hands on nothing more.
  void Stop() { subscribers_.clear(); }
  uint64_t NumRefused() const { return num_refused_; }

 private:
  void OnFrame(const std::string& robot, const FrameEventMsg::ConstPtr& message);
  void CountRefused(const std::string& reason);

  Handler handler_;
  std::atomic<uint64_t> num_refused_{0};
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace rovio_sfm
