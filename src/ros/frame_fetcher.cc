#include "rovio_sfm/ros/frame_fetcher.h"

#include <rovio_sfm/GetFrames.h>

#include <boost/make_shared.hpp>
#include <chrono>
#include <utility>

#include "rovio_sfm/ros/fetch_frames.h"
#include "rovio_sfm/ros/topics.h"

namespace rovio_sfm {
namespace {

constexpr std::chrono::milliseconds kDropAgain(20);
constexpr bool kPersistent = true;  // only such a client's connection can be dropped from outside

}  // namespace

FrontendLine::FrontendLine(ros::NodeHandle node, const std::string& robot, Answer answer)
    : node_(node),
      service_("/" + robot + "/" + topics::kGetFrames),
      answer_(std::move(answer)),
      worker_(kFetchQueue, WhenFull::kDropOldest, [this](const GapFetch& fetch) { Run(fetch); }) {}

// A call may just be about to begin on a new connection: so it is dropped until the call is over.
void FrontendLine::Stop() {
  {
    MutexLock lock(mutex_);
    is_stopped_ = true;
    while (is_calling_) {
      client_.shutdown();
      idle_.wait_for(mutex_, kDropAgain);
    }
  }
  worker_.Stop();
}

void FrontendLine::Run(const GapFetch& fetch) {
  ros::ServiceClient client = node_.serviceClient<rovio_sfm::GetFrames>(service_, kPersistent);
  std::vector<FetchedFrame> frames;
  FetchFrames(
      [&](GetFramesRequest& request, GetFramesResponse& response) {
        if (!Enter(client)) return false;
        const bool is_answered = client.isValid() && client.call(request, response);
        Leave();
        return is_answered;
      },
      fetch.first, fetch.end,
      [&](const FrameEventMsg& message, const FrameEvent& event) {
        frames.push_back({boost::make_shared<FrameEventMsg>(message), event});
      });
  answer_(fetch, std::move(frames));
}

bool FrontendLine::Enter(const ros::ServiceClient& client) {
  MutexLock lock(mutex_);
  if (is_stopped_) return false;
  client_ = client;
  is_calling_ = true;
  return true;
}

void FrontendLine::Leave() {
  MutexLock lock(mutex_);
  is_calling_ = false;
  client_ = ros::ServiceClient();
  idle_.notify_all();
}

void FrameFetcher::Fetch(const GapFetch& fetch) {
  MutexLock lock(mutex_);
  if (is_stopped_) return;
  std::unique_ptr<FrontendLine>& line = lines_[fetch.first.drive.robot];
  if (line == nullptr) {
    line = std::make_unique<FrontendLine>(node_, fetch.first.drive.robot, answer_);
  }
  line->Fetch(fetch);
}

void FrameFetcher::Stop() {
  MutexLock lock(mutex_);
  is_stopped_ = true;
  for (auto& [robot, line] : lines_) line->Stop();
}

}  // namespace rovio_sfm
