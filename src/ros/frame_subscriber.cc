#include "rovio_sfm/ros/frame_subscriber.h"

#include <optional>
#include <utility>

#include "rovio_sfm/ros/frame_event_message.h"
#include "rovio_sfm/ros/topics.h"

namespace rovio_sfm {
namespace {

constexpr double kWarnPeriodS = 10.0;

}  // namespace

FrameSubscriber::FrameSubscriber(ros::NodeHandle node, const std::vector<std::string>& robots,
                                 Handler handler)
    : handler_(std::move(handler)) {
  for (const std::string& robot : robots) {
    const boost::function<void(const FrameEventMsg::ConstPtr&)> handle =
        [this, robot](const FrameEventMsg::ConstPtr& message) { OnFrame(robot, message); };
    subscribers_.push_back(node.subscribe<FrameEventMsg>("/" + robot + "/" + topics::kFrames,
                                                         topics::kFramesQueue, handle));
  }
}

void FrameSubscriber::OnFrame(const std::string& robot, const FrameEventMsg::ConstPtr& message) {
  std::string error;
  std::optional<FrameEvent> event = FromMessage(*message, &error);
  if (!event) return CountRefused("frame of " + robot + " refused: " + error);
  if (event->id.drive.robot != robot) {
    return CountRefused("frame on /" + robot + "/frames refused: it says that its robot is " +
                        event->id.drive.robot);
  }
  handler_(message, std::move(*event));
}

void FrameSubscriber::CountRefused(const std::string& reason) {
  ++num_refused_;
  ROS_WARN_STREAM_THROTTLE(kWarnPeriodS, reason);
}

}  // namespace rovio_sfm
