#pragma once

#include <set>
#include <string>
#include <vector>

namespace rovio_sfm {

// What a node waits for.
struct AwaitedTopic {
  std::string what;             // for people: "images"
  std::string topic;            // resolved
  std::set<std::string> types;  // of messages, as rostopic says them
};

// The frames of every robot.
std::vector<AwaitedTopic> AwaitedFrames(const std::vector<std::string>& robots);

// Says on the terminal what a node waits for, and which topics of that type there are: 5 s after
// the start, then every 30 s. Not thread-safe.
class WaitingHints {
 public:
  // Call often, with what is awaited still (empty: all came); now_s of a steady clock.
  void Look(const std::vector<AwaitedTopic>& awaited, double now_s);

 private:
  double next_s_ = 0.0;  // 0: not called yet
};

// "no images on /a/image_raw yet; topics of that type: /b/image_raw"; others are those there are.
std::string Describe(const AwaitedTopic& awaited, const std::vector<std::string>& others);

}  // namespace rovio_sfm
