#pragma once

#include <ros/ros.h>
#include <rovio_sfm/FrameEventMsg.h>

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rovio_sfm/app/gap_filler.h"
#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/util/mutex.h"
#include "rovio_sfm/util/worker.h"

namespace rovio_sfm {

struct FetchedFrame {
  FrameEventMsg::ConstPtr message;
  FrameEvent event;
};

// Fetches frames of one robot's drives from its frontend's service get_frames, on a thread of its
// own. A call of a service knows no time limit: one that hangs holds up nothing but this thread.
// Stop drops its connection, which ends the call, so that the thread ends too.
class FrontendLine {
 public:
  using Answer = std::function<void(const GapFetch&, std::vector<FetchedFrame>)>;

  // The answer is called on the line's thread, once for every fetch that was not dropped.
  FrontendLine(ros::NodeHandle node, const std::string& robot, Answer answer);
  ~FrontendLine() { Stop(); }

  // Returns at once.
  void Fetch(const GapFetch& fetch) { worker_.Push(fetch); }
  // Ends the call that is out, and fetches nothing more.
  void Stop() EXCLUDES(mutex_);

 private:
  static constexpr size_t kFetchQueue = 4;  // drop oldest: the owner has one out at a time

  void Run(const GapFetch& fetch) EXCLUDES(mutex_);
  bool Enter(const ros::ServiceClient& client) EXCLUDES(mutex_);
  void Leave() EXCLUDES(mutex_);

  ros::NodeHandle node_;
  const std::string service_;
  const Answer answer_;
  Mutex mutex_;
  std::condition_variable_any idle_;
  ros::ServiceClient client_ GUARDED_BY(mutex_);  // of the call that is out
  bool is_calling_ GUARDED_BY(mutex_) = false;
  bool is_stopped_ GUARDED_BY(mutex_) = false;
  Worker<GapFetch> worker_;  // its thread uses the others
};

// The lines to all robots, made when they are first needed. Thread-safe.
class FrameFetcher {
 public:
  FrameFetcher(ros::NodeHandle node, FrontendLine::Answer answer)
      : node_(node), answer_(std::move(answer)) {}

  void Fetch(const GapFetch& fetch) EXCLUDES(mutex_);
  // Ends all calls that are out; later fetches are never answered.
  void Stop() EXCLUDES(mutex_);

 private:
  ros::NodeHandle node_;
  const FrontendLine::Answer answer_;
  Mutex mutex_;
  bool is_stopped_ GUARDED_BY(mutex_) = false;
  std::map<std::string, std::unique_ptr<FrontendLine>> lines_ GUARDED_BY(mutex_);  // by robot
};

}  // namespace rovio_sfm
