#include "rovio_sfm/ros/frame_subscriber.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "rovio_sfm/ros/frame_event_message.h"
#include "rovio_sfm/ros/topics.h"
#include "rovio_sfm/util/steady_clock.h"

namespace rovio_sfm {
namespace {

constexpr double kWarnPeriodS = 10.0;

}  // namespace

FrameSubscriber::FrameSubscriber(ros::NodeHandle node, const std::vector<std::string>& robots,
                                 Handler handler)
    : handler_(std::move(handler)) {
  for (const std::string& robot : robots) {
    const boost::function<void(const ros::MessageEvent<FrameEventMsg const>&)> handle =
        [this, robot,
         subscriber = subscribers_.size()](const ros::MessageEvent<FrameEventMsg const>& message) {
          OnFrame(robot, subscriber, message);
        };
    subscribers_.push_back(
        node.subscribe<FrameEventMsg, const ros::MessageEvent<FrameEventMsg const>&>(
            "/" + robot + "/" + topics::kFrames, topics::kFramesQueue, handle));
  }
}

void FrameSubscriber::OnFrame(const std::string& robot, size_t subscriber,
                              const ros::MessageEvent<FrameEventMsg const>& message) {
  std::string error;
  std::optional<FrameEvent> event = FromMessage(*message.getConstMessage(), &error);
  if (!event) return Refuse("frame of " + robot + " refused: " + error);
  if (event->id.drive.robot != robot) {
    return Refuse("frame on /" + robot + "/frames refused: it says that its robot is " +
                  event->id.drive.robot);
  }
  const double now_s = SteadySeconds();
  const bool is_only_sender = subscribers_.at(subscriber).getNumPublishers() <= 1;
  const auto refusal =
      senders_.RefusalOf(event->id.drive, {message.getPublisherName(), is_only_sender, now_s});
  if (refusal) {
    foreign_.Note(*refusal, now_s);
    return Refuse("frame refused: " + *refusal);
  }
  handler_(message.getConstMessage(), std::move(*event));
}

bool FrameSubscriber::HasSenders() const {
  return std::any_of(subscribers_.begin(), subscribers_.end(),
                     [](const ros::Subscriber& robot) { return robot.getNumPublishers() > 0; });
}

void FrameSubscriber::Refuse(const std::string& reason) {
  refused_.Note(reason, SteadySeconds());
  ROS_WARN_STREAM_THROTTLE(kWarnPeriodS, reason);
}

}  // namespace rovio_sfm
