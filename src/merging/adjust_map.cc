#include "rovio_sfm/merging/adjust_map.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "rovio_sfm/mapping/adjust_session.h"
#include "rovio_sfm/mapping/stage_options.h"

namespace rovio_sfm {
namespace {

constexpr int kFinalRounds = 5;
constexpr double kLooseFactor = 3.0;  // links may be that much worse before the adjustment

double PixelsPerSigma(const PlacedSession& placed, const FeatureRef& feature) {
  return placed.session->keyframe(feature.frame).sigmas[feature.feature] *
         placed.session->camera().MeanFocal();
}

// The sessions of a map by id.
class SessionIndex {
 public:
  explicit SessionIndex(const std::vector<PlacedSession>& sessions) {
    for (const PlacedSession& placed : sessions) placed_[placed.session->id()] = &placed;
  }

  // Null where the session is not of this map or its keyframe is not there.
  const PlacedSession* Find(const FeatureRef& feature) const {
    const auto it = placed_.find(feature.session);
    if (it == placed_.end()) return nullptr;
    return it->second->session->keyframes().count(feature.frame) == 0 ? nullptr : it->second;
  }

 private:
  std::map<SessionId, const PlacedSession*> placed_;
};

struct LinkEnds {
  const PlacedSession* a = nullptr;
  const PlacedSession* b = nullptr;
  const Landmark* landmark_a = nullptr;  // may be null, one of them
  const Landmark* landmark_b = nullptr;
};

std::optional<LinkEnds> EndsOf(const SessionIndex& index, const FeatureLink& link) {
  LinkEnds ends{index.Find(link.a), index.Find(link.b)};
  if (ends.a == nullptr || ends.b == nullptr) return std::nullopt;
  ends.landmark_a = ObservedLandmark(*ends.a->session, link.a);
  ends.landmark_b = ObservedLandmark(*ends.b->session, link.b);
  if (ends.landmark_a == nullptr && ends.landmark_b == nullptr) return std::nullopt;
  return ends;
}

bool Fits(const LinkEnds& ends, const FeatureLink& link, double max_error_sigmas) {
  if (ends.landmark_a != nullptr &&
      LinkErrorSigmas(*ends.a, ends.landmark_a->position, *ends.b, link.b) > max_error_sigmas) {
    return false;
  }
  return ends.landmark_b == nullptr ||
         LinkErrorSigmas(*ends.b, ends.landmark_b->position, *ends.a, link.a) <= max_error_sigmas;
}

uint32_t DropBadLinks(const std::vector<PlacedSession>& sessions, double max_error_sigmas,
                      std::vector<FeatureLink>* links) {
  const SessionIndex index(sessions);
  const auto bad = std::remove_if(links->begin(), links->end(), [&](const FeatureLink& link) {
    const auto ends = EndsOf(index, link);
    return ends && !Fits(*ends, link, max_error_sigmas);
  });
  const auto num_dropped = static_cast<uint32_t>(links->end() - bad);
  links->erase(bad, links->end());
  return num_dropped;
}

double MaxErrorSigmas(const MapperOptions& options) {
  return PruningLimits(options).max_error_sigmas;
}

// One round, as the map is adjusted again when its sessions end.
DelayedResult<std::unique_ptr<MapBundle>> SolveBeside(const std::vector<PlacedSession>& sessions,
                                                      const std::vector<FeatureLink>& links,
                                                      const MapperOptions& options,
                                                      Executor* executor, ResultTiming timing) {
  const Wait wait;
  BundleOptions solve = RunningBundleOptions(options);
  solve.is_given_up = wait.IsGivenUp();
  const auto max_frames = static_cast<size_t>(options.adjust.max_global_frames);
  auto solved = executor->Submit(
      [](MapBundle own, const BundleOptions& solve_options,
         size_t frames) -> std::unique_ptr<MapBundle> {
        if (!own.Solve(solve_options, frames).usable) return nullptr;
        return std::make_unique<MapBundle>(std::move(own));
      },
      MapBundle(sessions, links, kLooseFactor * MaxErrorSigmas(options)), solve, max_frames);
  return {std::move(solved), NumFrames(sessions), timing, wait};
}

// Sessions of one drive have one camera: that of the one with most keyframes.
void ShareCameras(const std::vector<PlacedSession>& sessions) {
  std::map<DriveId, const Session*> largest;
  for (const PlacedSession& placed : sessions) {
    const Session*& of_drive = largest[placed.session->drive()];
    if (of_drive == nullptr || placed.session->keyframes().size() > of_drive->keyframes().size()) {
      of_drive = placed.session;
    }
  }
  for (const PlacedSession& placed : sessions) {
    placed.session->SetCamera(largest.at(placed.session->drive())->camera());
  }
}

// False: nothing was changed.
bool RefineCameras(const std::vector<PlacedSession>& sessions,
                   const std::vector<FeatureLink>& links, const MapperOptions& options) {
  if (!MayRefine(options.adjust, NumFrames(sessions))) return false;
  std::vector<BundleIntrinsics> by_session;
  for (const PlacedSession& placed : sessions) {
    by_session.push_back(IntrinsicsOf(options.adjust, *placed.session));
  }
  MapBundle bundle(sessions, links, MaxErrorSigmas(options));
  if (!bundle.SolveIntrinsics(by_session, FinalBundleOptions(options, false))) return false;
  bundle.Apply();
  return true;
}

MapAdjustmentReport AdjustUntilSettled(const std::vector<PlacedSession>& sessions,
                                       const MapperOptions& options,
                                       std::vector<FeatureLink>* links) {
  const double max_error_sigmas = MaxErrorSigmas(options);
  const auto max_frames = static_cast<size_t>(options.adjust.max_global_frames);
  MapAdjustmentReport report;
  report.before = MeasureLinks(sessions, *links);
  size_t num_observations = 0;
  for (int round = 0; round <= kFinalRounds; ++round) {
    const bool is_last = round == kFinalRounds;
    for (const PlacedSession& placed : sessions) {
      if (!is_last) CompleteAllTracks(options, placed.session);
    }
    const double link_error = round == 0 ? kLooseFactor * max_error_sigmas : max_error_sigmas;
    MapBundle bundle(sessions, *links, link_error);
    if (!bundle.Solve(FinalBundleOptions(options, is_last), max_frames).usable) break;
    bundle.Apply();
    report.usable = true;
    report.shared = bundle.FindShared();
    if (is_last) break;
    report.num_dropped_links += DropBadLinks(sessions, max_error_sigmas, links);
    for (const PlacedSession& placed : sessions) PruneFinally(options, placed.session);
    const size_t count = bundle.num_observations();
    if (HasSettled(std::exchange(num_observations, count), count)) round = kFinalRounds - 1;
  }
  report.after = MeasureLinks(sessions, *links);
  return report;
}

}  // namespace

size_t NumFrames(const std::vector<PlacedSession>& sessions) {
  size_t count = 0;
  for (const PlacedSession& placed : sessions) count += placed.session->keyframes().size();
  return count;
}

LinkStatistics MeasureLinks(const std::vector<PlacedSession>& sessions,
                            const std::vector<FeatureLink>& links) {
  const SessionIndex index(sessions);
  std::vector<double> errors;
  LinkStatistics statistics;
  for (const FeatureLink& link : links) {
    const auto ends = EndsOf(index, link);
    if (!ends) continue;
    ++statistics.num_links;
    if (ends->landmark_a != nullptr) {
      errors.push_back(LinkErrorSigmas(*ends->a, ends->landmark_a->position, *ends->b, link.b) *
                       PixelsPerSigma(*ends->b, link.b));
    }
    if (ends->landmark_b != nullptr) {
      errors.push_back(LinkErrorSigmas(*ends->b, ends->landmark_b->position, *ends->a, link.a) *
                       PixelsPerSigma(*ends->a, link.a));
    }
  }
  if (errors.empty()) return statistics;
  std::sort(errors.begin(), errors.end());
  statistics.median_error_px = errors[errors.size() / 2];
  return statistics;
}

MapAdjustmentReport AdjustMapFinally(const std::vector<PlacedSession>& sessions,
                                     const MapperOptions& options,
                                     std::vector<FeatureLink>* links) {
  ShareCameras(sessions);
  const MapAdjustmentReport first = AdjustUntilSettled(sessions, options, links);
  if (!first.usable || !RefineCameras(sessions, *links, options)) return first;
  MapAdjustmentReport report = AdjustUntilSettled(sessions, options, links);
  report.before = first.before;
  report.num_dropped_links += first.num_dropped_links;
  return report;
}

SharedLandmarks FindSharedLandmarks(const std::vector<PlacedSession>& sessions,
                                    const std::vector<FeatureLink>& links,
                                    const MapperOptions& options) {
  return MapBundle(sessions, links, MaxErrorSigmas(options)).FindShared();
}

MapAdjustment::MapAdjustment(const std::vector<PlacedSession>& sessions,
                             const std::vector<FeatureLink>& links, const MapperOptions& options,
                             Executor* executor, ResultTiming timing)
    : sessions_(sessions), result_(SolveBeside(sessions, links, options, executor, timing)) {}

MapAdjustmentReport MapAdjustment::Apply(const MapperOptions& options,
                                         std::vector<FeatureLink>* links, StageTimes* times) {
  MapAdjustmentReport report;
  if (const std::unique_ptr<MapBundle> bundle = result_.Take(times)) {
    bundle->Apply();
    report.usable = true;
    report.shared = bundle->FindShared();
    report.num_dropped_links =
        DropBadLinks(sessions_, kLooseFactor * MaxErrorSigmas(options), links);
    for (const PlacedSession& placed : sessions_) {
      PruneAllLandmarks(PruningLimits(options), placed.session);
    }
  }
  report.after = MeasureLinks(sessions_, *links);
  return report;
}

}  // namespace rovio_sfm
