#include "rovio_sfm/ros/finish_actions.h"

#include <string>
#include <utility>

#include "rovio_sfm/ros/topics.h"

namespace rovio_sfm {
namespace {

// One job of a kind waits: an action's takes up the newest goal, whichever asked for it.
std::vector<LaneOptions> WorkerLanes() {
  return {{1, LaneFull::kRefuse}, {1, LaneFull::kRefuse}, {1, LaneFull::kRefuse}};
}

template <typename Server, typename Result>
void EndGoal(const Result& result, Server* server) {
  if (result.status.code == Status::OK) {
    server->setSucceeded(result, result.status.message);
  } else if (result.status.code == Status::CANCELLED) {
    server->setPreempted(result, result.status.message);
  } else {
    server->setAborted(result, result.status.message);
  }
}

}  // namespace

FinishActions::FinishActions(ros::NodeHandle node, FinishSources sources)
    : publisher_(node),
      finisher_(std::move(sources), &shelf_),
      densify_(node, topics::kDensify, false),
      surface_(node, topics::kReconstructSurface, false),
      worker_(WorkerLanes(), [](const Job& job) { job(); }) {
  densify_.registerGoalCallback([this] {
    worker_.Push(kDensifyLane, [this] {
      Run(&densify_, [this](const DensifyGoal& goal, const GoalProgress& progress) {
        return finisher_.Densify(goal, progress);
      });
    });
  });
  surface_.registerGoalCallback([this] {
    worker_.Push(kSurfaceLane, [this] {
      Run(&surface_, [this](const ReconstructSurfaceGoal& goal, const GoalProgress& progress) {
        return finisher_.ReconstructSurface(goal, progress);
      });
    });
  });
  densify_.start();
  surface_.start();
}

FinishActions::~FinishActions() {
  Stop();
  worker_.Stop();
}

void FinishActions::RefreshGrid() {
  worker_.Push(kGridLane, [this] { finisher_.MakeRootGrid(); });
}

void FinishActions::Publish(const MapPicture& picture) {
  publisher_.Publish(picture, shelf_.Fitting(picture));
}

template <typename Action, typename Answer>
void FinishActions::Run(actionlib::SimpleActionServer<Action>* server, const Answer& answer) {
  if (is_stopped_ || !server->isNewGoalAvailable()) return;
  const auto goal = server->acceptNewGoal();
  const GoalProgress progress = [this, server](const std::string& stage, size_t num_done,
                                               size_t num_total) {
    typename actionlib::SimpleActionServer<Action>::Feedback feedback;
    feedback.stage = stage;
    feedback.num_done = static_cast<uint32_t>(num_done);
    feedback.num_total = static_cast<uint32_t>(num_total);
    server->publishFeedback(feedback);
    return !is_stopped_ && !server->isPreemptRequested();
  };
  EndGoal(answer(*goal, progress), server);
}

}  // namespace rovio_sfm
