#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/ros.h>
#include <rovio_sfm/DensifyAction.h>
#include <rovio_sfm/ReconstructSurfaceAction.h>

#include <atomic>

#include "rovio_sfm/ros/job_worker.h"
#include "rovio_sfm/ros/map_finisher.h"
#include "rovio_sfm/ros/product_publisher.h"

namespace rovio_sfm {

// Serves the actions densify and reconstruct_surface on a thread of its own, one goal after the
// other. As actionlib has it, a newer goal of an action cancels the older one.
class FinishActions {
 public:
  // Callbacks come by the handle's queue.
  FinishActions(ros::NodeHandle node, FinishSources sources);
  ~FinishActions();

  // The grid of the root map is made anew, soon. From any thread.
  void RefreshGrid();
  // Sends what was made, when it changed; call now and then, from one thread.
  void Publish(const MapPicture& picture);
  // Goals that are under way end at their next step. From any thread.
  void Stop() { is_stopped_ = true; }

 private:
  enum Lane : size_t { kDensifyLane, kSurfaceLane, kGridLane };

  template <typename Action, typename Answer>
  void Run(actionlib::SimpleActionServer<Action>* server, const Answer& answer);

  std::atomic<bool> is_stopped_{false};
  ProductShelf shelf_;
  ProductPublisher publisher_;
  MapFinisher finisher_;  // of the worker
  actionlib::SimpleActionServer<DensifyAction> densify_;
  actionlib::SimpleActionServer<ReconstructSurfaceAction> surface_;
  JobWorker worker_;  // its thread uses the others
};

}  // namespace rovio_sfm
