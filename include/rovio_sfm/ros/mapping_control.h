#pragma once

#include <ros/ros.h>

#include <condition_variable>
#include <string>

#include "rovio_sfm/app/web_router.h"
#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm {

// Calls mapping's services for the live page. Call may run on any thread, one at a time; it lasts
// as long as mapping takes. Stop ends a call that hangs, and refuses later ones.
class MappingControl {
 public:
  explicit MappingControl(ros::NodeHandle node) : node_(node) {}

  ControlReply Call(const ControlOrder& order);
  void Stop() EXCLUDES(mutex_);

 private:
  template <typename Service>
  ControlReply CallService(const char* name, const typename Service::Request& request);
  bool Enter(const ros::ServiceClient& client) EXCLUDES(mutex_);
  void Leave() EXCLUDES(mutex_);

  ros::NodeHandle node_;
  Mutex mutex_;
  std::condition_variable_any idle_;
  ros::ServiceClient client_ GUARDED_BY(mutex_);
  bool is_calling_ GUARDED_BY(mutex_) = false;
  bool is_stopped_ GUARDED_BY(mutex_) = false;
};

}  // namespace rovio_sfm
