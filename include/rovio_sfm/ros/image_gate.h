#pragma once

#include <deque>
#include <optional>
#include <string>

#include "rovio_sfm/pipeline/events.h"
#include "rovio_sfm/ros/robot_sensors.h"

namespace rovio_sfm {

// How long an image may wait for the odometry and the head's pose at its stamp, which come on
// topics of their own.
struct GateOptions {
  double max_wait_s = 0.3;      // then it goes without; 0 to 10
  double startup_wait_s = 1.0;  // so long after the first image both are still expected; 0 to 60

  bool IsValid(std::string* error) const;
};

struct WaitingImage {
  std_msgs::Header header;
  std::string name;
  ImageBytes bytes;
};

// Images on their way into a frontend, in order; holds back those about which more may become
// known. When full the oldest is dropped. Times are seconds of any steady clock. Not thread-safe;
// the sensors are borrowed.
class ImageGate {
 public:
  static constexpr size_t kCapacity = 16;  // images; drop oldest

  ImageGate(const GateOptions& options, const RobotSensors* sensors)
      : options_(options), sensors_(sensors) {}

  void Add(WaitingImage image, double now_s);
  // The oldest image, if nothing more is to be waited for.
  std::optional<ImageEvent> Take(double now_s);

  uint64_t NumDropped() const { return num_dropped_; }

 private:
  struct Entry {
    WaitingImage image;
    double arrived_s = 0.0;
  };

  bool IsReady(const Entry& entry, double now_s);

  GateOptions options_;
  const RobotSensors* sensors_;
  std::deque<Entry> waiting_;
  std::optional<double> first_s_;
  bool has_seen_head_ = false;
  uint64_t num_dropped_ = 0;
};

}  // namespace rovio_sfm
