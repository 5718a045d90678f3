#pragma once

#include <ros/ros.h>
#include <rovio_sfm/FrameEventMsg.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "rovio_sfm/app/frame_senders.h"
#include "rovio_sfm/ros/newest_refusal.h"
#include "rovio_sfm/scene/events.h"

namespace rovio_sfm {

// Listens to /<robot>/frames of all robots. Malformed events, events on another robot's topic and
// those of a foreign sender (app/frame_senders.h) are refused, counted and warned of; the others
// are handed on, in the spinning thread.
class FrameSubscriber {
 public:
  using Handler = std::function<void(const FrameEventMsg::ConstPtr&, FrameEvent)>;

  FrameSubscriber(ros::NodeHandle node, const std::vector<std::string>& robots, Handler handler);

  // Hands on nothing more.
  void Stop() { subscribers_.clear(); }
  // Whether anybody is connected who may send.
  bool HasSenders() const;
  const NewestRefusal& refused() const { return refused_; }
  // Of those: of a foreign sender.
  const NewestRefusal& foreign() const { return foreign_; }

 private:
  void OnFrame(const std::string& robot, size_t subscriber,
               const ros::MessageEvent<FrameEventMsg const>& message);
  void Refuse(const std::string& reason);

  Handler handler_;
  FrameSenders senders_;  // of the spinning thread
  NewestRefusal refused_, foreign_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace rovio_sfm
