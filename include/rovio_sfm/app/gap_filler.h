#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {

// A frame on its way to the mapper, and what takes it there.
struct ArrivedFrame {
  FrameId id;
  std::function<void()> deliver;
  size_t num_bytes = 0;  // that it takes while it is held
};

// The frames of a drive from `first` to before `end`, to be fetched from who sent it.
struct GapFetch {
  uint64_t ticket = 0;  // names the answer
  FrameId first;
  uint32_t end = 0;
};

struct GapFillerOptions {
  double timeout_s = 5.0;  // steady; a fetch that is out for longer is given up
  size_t max_held = 200;   // frames of a robot that wait for a fetch; one more gives it up,
  size_t max_held_bytes = 128u << 20;  // as more than this does
};

// Hands on the frames of every robot in order. While what is missing before a frame is fetched,
// this and later frames of that robot are held; those of others flow. A fetch that is not answered
// in time is given up: its frames are lost, a late answer is ignored, and until it comes no other
// is begun for that robot, so that a sender that hangs costs the time once. Thread-compatible; it
// reads no clock: times are steady seconds of the caller.
class GapFiller {
 public:
  // The first index of the frame's drive that is missing before it; its own if none is.
  using NextIndex = std::function<uint32_t(const FrameId&)>;
  // Begins a fetch and returns at once; its answer comes to TakeAnswer, once, if ever.
  using BeginFetch = std::function<void(const GapFetch&)>;

  GapFiller(const GapFillerOptions& options, NextIndex next_index, BeginFetch begin_fetch)
      : options_(options),
        next_index_(std::move(next_index)),
        begin_fetch_(std::move(begin_fetch)) {}

  void Add(ArrivedFrame frame, double now_s);
  // What was found of a fetch, by rising index: possibly nothing.
  void TakeAnswer(uint64_t ticket, const std::vector<ArrivedFrame>& found, double now_s);
  // Gives up the fetches that have been out for too long.
  void CheckTime(double now_s);
  // Waits for nothing more of a robot, or of any: what is held is handed on.
  void EndWait(const std::string& robot, double now_s);
  void EndAllWaits(double now_s);

  size_t NumHeld() const;
  uint64_t num_given_up() const { return num_given_up_; }  // gaps, filled by nobody
  uint64_t num_late_answers() const { return num_late_answers_; }

 private:
  struct Wait {
    GapFetch fetch;
    double deadline_s = 0.0;
    std::deque<ArrivedFrame> held;  // the frame after the gap first; never empty
    size_t num_held_bytes = 0;
  };

  bool IsSilent(const std::string& robot) const;
  void GiveUp(const std::string& robot, const std::string& reason, double now_s);
  void Release(const std::string& robot, double now_s);

  GapFillerOptions options_;
  NextIndex next_index_;
  BeginFetch begin_fetch_;
  std::map<std::string, Wait> waits_;           // by robot
  std::map<uint64_t, std::string> unanswered_;  // robots of fetches given up, by ticket
  uint64_t last_ticket_ = 0, num_given_up_ = 0, num_late_answers_ = 0;
};

}  // namespace rovio_sfm
