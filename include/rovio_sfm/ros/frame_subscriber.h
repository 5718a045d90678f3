#pragma once

#include <ros/ros.h>
#include <rovio_sfm/FrameEventMsg.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "rovio_sfm/app/frame_senders.h"
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
  uint64_t NumRefused() const { return num_refused_; }
  // Of those: of a foreign sender.
  uint64_t NumForeign() const { return num_foreign_; }
  // What was last refused of a foreign sender, within the last half minute; else empty.
  std::string ForeignSender() const;

 private:
  void OnFrame(const std::string& robot, size_t subscriber,
               const ros::MessageEvent<FrameEventMsg const>& message);
  void CountRefused(const std::string& reason);

  Handler handler_;
  FrameSenders senders_;  // of the spinning thread, as what was refused
  std::string foreign_;
  double foreign_s_ = 0.0;
  std::atomic<uint64_t> num_refused_{0}, num_foreign_{0};
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace rovio_sfm
