#include "rovio_sfm/mapping/adjust_session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rovio_sfm/mapping/stage_options.h"
#include "rovio_sfm/sfm/adjust_by_window.h"
#include "rovio_sfm/sfm/refine_intrinsics.h"
#include "rovio_sfm/sfm/triangulate_tracks.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kMinShared = 15;     // landmarks that make a neighbour worth adjusting
constexpr size_t kMaxFixedFrames = 15;  // of a local adjustment
constexpr size_t kMinGlobalFrames = 6;  // smaller maps are covered by local adjustments
constexpr int kFinalRounds = 5;
constexpr double kTolerance = 1e-4;  // the next adjustment goes on where this one ends
constexpr double kLastTolerance = 1e-6;
// What an adjustment may cost, so that a frame costs the same however long the drive is; 4 to 10
// iterations. Many views of each landmark leave little to gain by more.
constexpr double kLocalReprojections = 6e4, kRunningReprojections = 7e5;
constexpr double kSettledShare = 0.0005;  // of the observations, more or fewer than a round ago

BundleOptions LocalBundleOptions(const MapperOptions& options) {
  BundleOptions bundle_options = RunningBundleOptions(options);
  bundle_options.max_reprojections = kLocalReprojections;
  return bundle_options;
}

// Of a whole session. False: nothing was changed.
bool Adjust(const BundleOptions& bundle_options, const AdjustOptions& options,
            SessionBundle* bundle) {
  const auto max_frames = static_cast<size_t>(options.max_global_frames);
  return AdjustByWindow(&bundle->problem, bundle_options, max_frames).usable;
}

void AddUp(const PruneReport& part, PruneReport* total) {
  total->num_observations += part.num_observations;
  total->num_landmarks += part.num_landmarks;
  total->num_frames += part.num_frames;
}

// False: nothing was changed.
bool RefineCamera(const MapperOptions& options, Session* session) {
  SessionBundle bundle = MakeGlobalBundle(*session);
  BundleProblem& problem = bundle.problem;
  if (!MayRefine(options.adjust, problem.cameras.size())) return false;
  problem.intrinsics.push_back(IntrinsicsOf(options.adjust, *session));
  if (!RefineIntrinsics(FinalBundleOptions(options, false), &problem)) return false;
  const Eigen::Vector3d& correction = problem.intrinsics[0].correction;
  if (!session->SetCamera(CorrectedCamera(session->camera(), correction))) return false;
  ApplyBundle(bundle, true, session);
  return true;
}

}  // namespace

PruneReport AdjustLocally(uint32_t frame, const MapperOptions& options, Session* session) {
  const auto max_free = static_cast<size_t>(options.adjust.local_frames);
  SessionBundle bundle = MakeLocalBundle(
      *session, CovisibleFrames(*session, frame, max_free, kMinShared), kMaxFixedFrames);
  if (AdjustBundle(&bundle.problem, LocalBundleOptions(options)).usable) {
    ApplyBundle(bundle, false, session);
  }
  return PruneLandmarks(bundle.tracks, PruningLimits(options), session);
}

void CompleteAllTracks(const MapperOptions& options, Session* session) {
  const LandmarkLimits limits = TriangulationLimits(options);
  for (const auto& [index, frame] : session->keyframes()) TriangulateTracks(index, limits, session);
}

bool HasSettled(size_t num_before, size_t num_now) {
  const double before = static_cast<double>(num_before), now = static_cast<double>(num_now);
  return std::abs(now - before) <= kSettledShare * now;
}

PruneReport PruneFinally(const MapperOptions& options, Session* session) {
  LandmarkLimits limits = PruningLimits(options);
  const double spread = ResidualSpread(*session);
  limits.max_error_sigmas =
      std::min(limits.max_error_sigmas, options.prune.final_error_sigmas * std::sqrt(2.0) * spread);
  return PruneAllLandmarks(limits, session);
}

BundleOptions RunningBundleOptions(const MapperOptions& options) {
  BundleOptions bundle_options{options.adjust.running_max_iterations, LossSigmas(options)};
  bundle_options.function_tolerance = kTolerance;
  bundle_options.max_reprojections = kRunningReprojections;
  return bundle_options;
}

BundleOptions FinalBundleOptions(const MapperOptions& options, bool is_last) {
  BundleOptions bundle_options{options.adjust.final_max_iterations, LossSigmas(options)};
  bundle_options.function_tolerance = is_last ? kLastTolerance : kTolerance;
  bundle_options.settle_points = true;
  return bundle_options;
}

PruneReport AdjustFinally(const MapperOptions& options, Session* session) {
  PruneReport total;
  size_t num_observations = 0;
  for (int round = 0; round < kFinalRounds; ++round) {
    CompleteAllTracks(options, session);
    SessionBundle bundle = MakeGlobalBundle(*session);
    if (!Adjust(FinalBundleOptions(options, false), options.adjust, &bundle)) return total;
    ApplyBundle(bundle, true, session);
    AddUp(PruneFinally(options, session), &total);
    const size_t count = bundle.problem.observations.size();
    if (HasSettled(std::exchange(num_observations, count), count)) break;
  }
  SessionBundle bundle = MakeGlobalBundle(*session);
  if (Adjust(FinalBundleOptions(options, true), options.adjust, &bundle)) {
    ApplyBundle(bundle, true, session);
  }
  return total;
}

BundleIntrinsics IntrinsicsOf(const AdjustOptions& options, const Session& session) {
  return {session.camera(),
          Eigen::Vector3d::Zero(),
          CorrectionOf(session.camera(), session.given_camera()),
          {options.focal_sigma, options.center_sigma, options.center_sigma}};
}

bool MayRefine(const AdjustOptions& options, size_t num_frames) {
  return options.focal_sigma > 0.0 && num_frames <= static_cast<size_t>(options.max_global_frames);
}

PruneReport AdjustWithCamera(const MapperOptions& options, Session* session) {
  PruneReport total = AdjustFinally(options, session);
  if (RefineCamera(options, session)) AddUp(AdjustFinally(options, session), &total);
  return total;
}

GlobalAdjustment::GlobalAdjustment(const MapperOptions& options, Executor* executor,
                                   ResultTiming timing)
    : options_(options.adjust),
      bundle_options_(RunningBundleOptions(options)),
      executor_(executor),
      timing_(timing) {}

void GlobalAdjustment::MaybeStart(const Session& session) {
  const size_t num_frames = session.keyframes().size();
  const size_t num_landmarks = session.landmarks().size();
  const double growth = 1.0 + options_.global_growth;
  const bool grown =
      static_cast<double>(num_frames) > growth * static_cast<double>(num_frames_at_last_) ||
      static_cast<double>(num_landmarks) > growth * static_cast<double>(num_landmarks_at_last_);
  if (running_ || num_frames < kMinGlobalFrames || !grown) return;
  Start(session);
}

void GlobalAdjustment::Restart(const Session& session) {
  if (running_) Start(session);
}

void GlobalAdjustment::Start(const Session& session) {
  num_frames_at_last_ = session.keyframes().size();
  num_landmarks_at_last_ = session.landmarks().size();
  const Wait wait;
  BundleOptions bundle_options = bundle_options_;
  bundle_options.is_given_up = wait.IsGivenUp();
  auto solved = executor_->Submit(
      [](SessionBundle bundle, const BundleOptions& solve, const AdjustOptions& options) {
        if (!Adjust(solve, options, &bundle)) bundle = {};
        return bundle;
      },
      MakeGlobalBundle(session), bundle_options, options_);
  running_ = std::make_unique<DelayedResult<SessionBundle>>(std::move(solved), num_frames_at_last_,
                                                            timing_, wait);
}

bool GlobalAdjustment::Advance(Session* session, StageTimes* times) {
  if (!running_) return false;
  running_->CountKeyframe();
  if (!running_->IsDue()) return false;
  const SessionBundle bundle = running_->Take(times);
  running_.reset();
  if (bundle.frames.empty()) return false;
  ApplyBundle(bundle, true, session);
  return true;
}

}  // namespace rovio_sfm
