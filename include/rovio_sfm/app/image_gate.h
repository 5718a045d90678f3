#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// How long an image may wait for the odometry and the head's pose at its stamp, which come on
// topics of their own.
struct GateOptions {
  double max_wait_s = 0.3;
  double startup_wait_s = 1.0;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("max_wait_s", max_wait_s, 0.0, 10.0, "then an image goes without");
    table.AddNumber("startup_wait_s", startup_wait_s, 0.0, 60.0,
                    "so long after the first image both are still expected");
  }
};

// An image as it came.
struct RawImage {
  int64_t stamp_ns = 0;
  std::string camera_frame;                           // tf frame of the camera; empty: none
  std::string name;                                   // file name or sequence number, for people
  std::shared_ptr<const std::vector<uint8_t>> bytes;  // JPEG or PNG
};

// What is known of a robot at the stamps of its images.
class RobotKnowledge {
 public:
  virtual ~RobotKnowledge() = default;

  virtual bool HasCamera() const = 0;
  virtual bool HasOdometry() const = 0;
  // True if the head's pose is known at any stamp, be it after the image's or long before.
  virtual bool HasHead(const RawImage& image) const = 0;
  // True if later odometry or transforms would not add to what is known at the image's stamp.
  virtual bool OdometryCovers(const RawImage& image) const = 0;
  virtual bool KnowsHead(const RawImage& image) const = 0;
  // The event of an image, with whatever is known at its stamp. Needs HasCamera().
  virtual ImageEvent MakeEvent(const RawImage& image) const = 0;
};

// Images on their way into a frontend, in order; holds back those about which more may become
// known. When full the oldest is dropped. Times are seconds of any steady clock. Not thread-safe;
// the knowledge is borrowed.
class ImageGate {
 public:
  static constexpr size_t kCapacity = 16;          // images; drop oldest
  static constexpr size_t kMaxBytes = 128u << 20;  // of all but the newest; likewise

  ImageGate(const GateOptions& options, const RobotKnowledge* robot)
      : options_(options), robot_(robot) {}

  void Add(RawImage image, double now_s);
  // The oldest image, if nothing more is to be waited for.
  std::optional<ImageEvent> Take(double now_s);

  uint64_t NumDropped() const { return num_dropped_; }

 private:
  struct Entry {
    RawImage image;
    double arrived_s = 0.0;
  };

  bool IsReady(const Entry& entry, double now_s) const;
  size_t NumBytes() const;

  GateOptions options_;
  const RobotKnowledge* robot_;
  std::deque<Entry> waiting_;
  std::optional<double> first_s_;
  uint64_t num_dropped_ = 0;
};

}  // namespace rovio_sfm
