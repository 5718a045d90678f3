#include "rovio_sfm/mapping/register_frame.h"

#include <algorithm>
#include <utility>

#include "rovio_sfm/mapping/make_keyframe.h"
#include "rovio_sfm/mapping/stage_options.h"
#include "rovio_sfm/sfm/resect_frame.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMinLightInliers = 8;

ResectFrameOptions ResectOptionsOf(const MapperOptions& options) {
  return {options.resect.threshold_px / options.pixel_sigma_px, options.resect.max_iterations,
          LossSigmas(options)};
}

std::optional<Registration> Accept(const std::optional<Resection>& resection, size_t num_matches,
                                   size_t min_inliers) {
  if (!resection || resection->inliers.size() < min_inliers) return std::nullopt;
  return Registration{resection->cam_from_map, static_cast<uint32_t>(num_matches),
                      static_cast<uint32_t>(resection->inliers.size())};
}

size_t MinInliers(const MapperOptions& options) {
  return static_cast<size_t>(options.resect.min_inliers);
}

// No landmark hangs on a light frame: fewer pose it, where they are half of what it shows.
size_t MinLightInliers(size_t num_observations, const MapperOptions& options) {
  return std::max(kMinLightInliers, std::min(MinInliers(options), (num_observations + 1) / 2));
}

std::optional<Registration> Register(const std::vector<PoseObservation>& observations,
                                     uint64_t stream, size_t min_inliers,
                                     const MapperOptions& options) {
  Rng rng = Rng(options.seed).Fork(stream);
  return Accept(ResectFrame(observations, ResectOptionsOf(options), rng), observations.size(),
                min_inliers);
}

std::optional<Registration> RegisterNear(const std::vector<PoseObservation>& observations,
                                         const Rigid3& predicted_cam_from_map, size_t min_inliers,
                                         const MapperOptions& options) {
  return Accept(
      ResectFromPrediction(observations, predicted_cam_from_map, ResectOptionsOf(options)),
      observations.size(), min_inliers);
}

// Of the session's own landmark, else of the first sibling's that has one.
std::optional<Eigen::Vector3d> PositionOf(TrackId track, const Session& session,
                                          const std::vector<Sibling>& siblings) {
  if (const Landmark* landmark = session.FindLandmark(track)) return landmark->position;
  for (const Sibling& sibling : siblings) {
    const Landmark* landmark = sibling.session->FindLandmark(track);
    if (landmark != nullptr) return sibling.session_from_sibling * landmark->position;
  }
  return std::nullopt;
}

std::vector<PoseObservation> ObservationsOf(const LightFrame& frame, const MapperOptions& options,
                                            const Session& session,
                                            const std::vector<Sibling>& siblings) {
  std::vector<PoseObservation> observations;
  const double sigma = options.pixel_sigma_px / session.camera().MeanFocal();
  for (size_t i = 0; i < frame.tracks.size(); ++i) {
    const auto position = PositionOf(frame.tracks[i], session, siblings);
    if (position) observations.push_back({*position, frame.points[i], sigma});
  }
  return observations;
}

}  // namespace

std::optional<Registration> RegisterObservations(const std::vector<PoseObservation>& observations,
                                                 uint64_t stream, const MapperOptions& options) {
  return Register(observations, stream, MinInliers(options), options);
}

std::optional<Registration> RegisterKeyframe(const FrameEvent& event, const MapperOptions& options,
                                             const Session& session) {
  std::vector<PoseObservation> observations;
  for (size_t i = 0; i < event.tracks.size(); ++i) {
    if (event.tracks[i] == 0) continue;
    const Landmark* landmark = session.FindLandmark(event.tracks[i]);
    if (landmark == nullptr) continue;
    observations.push_back(
        ObserveLandmark(event, static_cast<uint32_t>(i), landmark->position, options));
  }
  return RegisterObservations(observations, event.id.index, options);
}

std::optional<Registration> RegisterAgain(uint32_t frame, const MapperOptions& options,
                                          const Session& session) {
  std::vector<PoseObservation> observations;
  const Keyframe& keyframe = session.keyframe(frame);
  for (size_t i = 0; i < keyframe.tracks.size(); ++i) {
    if (keyframe.tracks[i] == 0) continue;
    const Landmark* landmark = session.FindLandmark(keyframe.tracks[i]);
    if (landmark == nullptr) continue;
    observations.push_back({landmark->position, keyframe.points[i], keyframe.sigmas[i]});
  }
  return RegisterObservations(observations, frame, options);
}

bool PoseLightFrame(uint32_t index, const std::optional<Rigid3>& predicted_cam_from_session,
                    const MapperOptions& options, LightFrame* frame, const Session& session,
                    const std::vector<Sibling>& siblings) {
  auto reference = session.keyframes().lower_bound(index);
  while (reference != session.keyframes().begin()) {
    if (!(--reference)->second.weak) break;
  }
  if (reference == session.keyframes().end() || reference->second.weak) return false;
  const std::vector<PoseObservation> observations =
      ObservationsOf(*frame, options, session, siblings);
  const size_t min_inliers = MinLightInliers(observations.size(), options);
  std::optional<Registration> registration;
  if (predicted_cam_from_session) {
    registration = RegisterNear(observations, *predicted_cam_from_session, min_inliers, options);
  }
  if (!registration) registration = Register(observations, index, min_inliers, options);
  if (!registration) return false;
  frame->reference = reference->first;
  frame->cam_from_reference =
      registration->cam_from_session * Inverse(reference->second.cam_from_session);
  frame->num_inliers = registration->num_inliers;
  return true;
}

void RefineLightFrames(const MapperOptions& options, Session* session) {
  std::vector<std::pair<uint32_t, LightFrame>> refined;
  for (const auto& [index, frame] : session->light_frames()) {
    const Rigid3& reference = session->keyframe(frame.reference).cam_from_session;
    const std::vector<PoseObservation> observations = ObservationsOf(frame, options, *session, {});
    const auto registration = RegisterNear(observations, frame.cam_from_reference * reference,
                                           MinLightInliers(observations.size(), options), options);
    if (!registration) continue;
    refined.emplace_back(index, frame);
    refined.back().second.cam_from_reference = registration->cam_from_session * Inverse(reference);
    refined.back().second.num_inliers = registration->num_inliers;
  }
  for (const auto& [index, frame] : refined) {
    session->SetLightPose(index, frame.reference, frame.cam_from_reference, frame.num_inliers);
  }
}

}  // namespace rovio_sfm
