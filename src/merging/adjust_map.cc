#include "rovio_sfm/merging/adjust_map.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "rovio_sfm/mapping/adjust_session.h"
#include "rovio_sfm/mapping/stage_options.h"

namespace rovio_sfm {
namespace {

constexpr int kFinalRounds = 5;
constexpr double kLooseFactor = 3.0;  // links may be that much worse before the adjustment

// A keyframe, and where its camera stands in the map.
struct PlacedFrame {
  const PlacedSession* placed = nullptr;
  const Keyframe* keyframe = nullptr;
  Rigid3 cam_from_map;
};

// The keyframes of a map, each looked up once: links are many times as many.
class FrameIndex {
 public:
  explicit FrameIndex(const std::vector<PlacedSession>& sessions) {
    for (const PlacedSession& placed : sessions) sessions_[placed.session->id()] = {&placed, {}};
  }

  // Null where the session is not of this map or its keyframe is not there.
  const PlacedFrame* Find(const FeatureRef& feature) {
    const auto it = sessions_.find(feature.session);
    if (it == sessions_.end()) return nullptr;
    auto& [placed, frames] = it->second;
    const auto known = frames.find(feature.frame);
    if (known != frames.end()) return &known->second;
    const auto keyframe = placed->session->keyframes().find(feature.frame);
    if (keyframe == placed->session->keyframes().end()) return nullptr;
    const PlacedFrame frame{placed, &keyframe->second, CamFromMap(*placed, feature.frame)};
    return &frames.emplace(feature.frame, frame).first->second;
  }

 private:
  struct OfSession {
    const PlacedSession* placed = nullptr;
    std::unordered_map<uint32_t, PlacedFrame> frames;  // look-up only
  };

  std::map<SessionId, OfSession> sessions_;
};

struct LinkEnd {
  const PlacedFrame* frame = nullptr;
  uint32_t feature = 0;
  const Landmark* landmark = nullptr;  // may be null at one end
};

LinkEnd EndOf(const FeatureRef& feature, FrameIndex* index) {
  const PlacedFrame* frame = index->Find(feature);
  if (frame == nullptr) return {};
  const Session& session = *frame->placed->session;
  return {frame, feature.feature, ObservedLandmark(session, *frame->keyframe, feature.feature)};
}

// How far off the landmark at one end projects at the other, sigmas; none without a landmark.
std::optional<double> ErrorAcross(const LinkEnd& from, const LinkEnd& to) {
  if (from.landmark == nullptr) return std::nullopt;
  const Eigen::Vector3d in_map = from.frame->placed->map_from_session * from.landmark->position;
  return LinkErrorSigmas(in_map, to.frame->cam_from_map, *to.frame->keyframe, to.feature);
}

double PixelsPerSigma(const LinkEnd& end) {
  return end.frame->keyframe->sigmas[end.feature] *
         end.frame->placed->session->camera().MeanFocal();
}

// Of both ends' landmarks; none where a keyframe is missing, or both landmarks.
struct LinkErrors {
  std::optional<double> sigmas[2];
  double pixels_per_sigma[2] = {0.0, 0.0};
};

std::optional<LinkErrors> ErrorsOf(const FeatureLink& link, FrameIndex* index) {
  const LinkEnd a = EndOf(link.a, index), b = EndOf(link.b, index);
  if (a.frame == nullptr || b.frame == nullptr) return std::nullopt;
  if (a.landmark == nullptr && b.landmark == nullptr) return std::nullopt;
  return LinkErrors{{ErrorAcross(a, b), ErrorAcross(b, a)}, {PixelsPerSigma(b), PixelsPerSigma(a)}};
}

bool Fits(const LinkErrors& errors, double max_error_sigmas) {
  return errors.sigmas[0].value_or(0.0) <= max_error_sigmas &&
         errors.sigmas[1].value_or(0.0) <= max_error_sigmas;
}

uint32_t DropBadLinks(const std::vector<PlacedSession>& sessions, double max_error_sigmas,
                      std::vector<FeatureLink>* links) {
  FrameIndex index(sessions);
  const auto bad = std::remove_if(links->begin(), links->end(), [&](const FeatureLink& link) {
    const auto errors = ErrorsOf(link, &index);
    return errors && !Fits(*errors, max_error_sigmas);
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
  FrameIndex index(sessions);
  std::vector<double> errors_px;
  LinkStatistics statistics;
  for (const FeatureLink& link : links) {
    const auto errors = ErrorsOf(link, &index);
    if (!errors) continue;
    ++statistics.num_links;
    for (const int end : {0, 1}) {
      if (!errors->sigmas[end]) continue;
      errors_px.push_back(*errors->sigmas[end] * errors->pixels_per_sigma[end]);
    }
  }
  if (errors_px.empty()) return statistics;
  const auto middle = errors_px.begin() + static_cast<ptrdiff_t>(errors_px.size() / 2);
  std::nth_element(errors_px.begin(), middle, errors_px.end());
  statistics.median_error_px = *middle;
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
