#include "rovio_sfm/mapping/grow_map.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "rovio_sfm/mapping/adjust_session.h"
#include "rovio_sfm/mapping/link_tracks.h"
#include "rovio_sfm/mapping/make_keyframe.h"
#include "rovio_sfm/mapping/register_frame.h"
#include "rovio_sfm/mapping/search_landmarks.h"
#include "rovio_sfm/mapping/stage_options.h"
#include "rovio_sfm/sfm/triangulate_tracks.h"

namespace rovio_sfm {
namespace {

using TrackOfFeature = std::map<uint32_t, TrackId>;

// The session's landmarks that a frame outside it shows, those of its own tracks first.
TrackOfFeature LandmarksShown(const FrameEvent& event, const PlaceMatch& place,
                              const Session& session) {
  TrackOfFeature shown;
  for (uint32_t i = 0; i < event.tracks.size(); ++i) {
    if (event.tracks[i] == 0 || session.FindLandmark(event.tracks[i]) == nullptr) continue;
    shown[i] = session.RootOf(event.tracks[i]);
  }
  for (const OverlapPair& pair : place.pairs) {
    if (!(pair.other.drive == session.drive())) continue;
    for (const FeatureMatch& inlier : pair.inliers) {
      const FeatureRef feature{session.id(), pair.other.index, inlier.a};
      if (inlier.b >= event.tracks.size()) continue;
      if (ObservedLandmark(session, feature) == nullptr) continue;
      shown.try_emplace(inlier.b, session.keyframe(feature.frame).tracks[feature.feature]);
    }
  }
  return shown;
}

// The frame's features become members of the landmarks' tracks, one each, or their tracks united.
void JoinTracks(uint32_t frame, const TrackOfFeature& shown, const FilterF2Options& f2,
                Session* session) {
  std::vector<TrackLink> links;
  for (const auto& [feature, track] : shown) {
    if (session->MoveToTrack({frame, feature}, track)) continue;
    const TrackId own = session->keyframe(frame).tracks[feature];
    if (own != 0) links.push_back({own, track});
  }
  LinkTracks(f2, &links, session);
}

bool RejoinKeyframe(const FrameEvent& event, const PlaceMatch& place, const TrackOfFeature& shown,
                    const MapperOptions& options, const std::vector<Sibling>& siblings,
                    Session* session) {
  std::map<uint32_t, Eigen::Vector3d> positions;  // by feature: the first that tells one
  const auto add = [&](const TrackOfFeature& of, const Sibling& from) {
    for (const auto& [feature, track] : of) {
      const Eigen::Vector3d& position = from.session->landmarks().at(track).position;
      positions.emplace(feature, from.session_from_sibling * position);
    }
  };
  add(shown, {session, {}});
  for (const Sibling& sibling : siblings) {
    add(LandmarksShown(event, place, *sibling.session), sibling);
  }
  std::vector<PoseObservation> observations;
  for (const auto& [feature, position] : positions) {
    observations.push_back(ObserveLandmark(event, feature, position, options));
  }
  const auto registration = RegisterObservations(observations, event.id.index, options);
  if (!registration) return false;
  session->AddKeyframe(event.id.index,
                       MakeKeyframe(event, registration->cam_from_session, options));
  JoinTracks(event.id.index, shown, options.f2, session);
  return true;
}

bool RejoinLightFrame(const FrameEvent& event, const MapperOptions& options,
                      const std::vector<Sibling>& siblings, Session* session) {
  LightFrame frame = MakeLightFrame(event);
  if (!PoseLightFrame(event.id.index, {}, options, &frame, *session, siblings)) return false;
  session->AddLightFrame(event.id.index, std::move(frame));
  return true;
}

}  // namespace

MapGrowth GrowMap(uint32_t frame, const MapperOptions& options, const FrameStore& store,
                  StageTimes* times, Session* session) {
  MapGrowth growth;
  const LandmarkLimits triangulate = TriangulationLimits(options);
  {
    const auto scope = MeasureStage(times, "search");
    CompleteLandmarks(frame, triangulate.max_error_sigmas, session);
    SearchLandmarksOptions search;
    search.max_error_sigmas = PruningLimits(options).max_error_sigmas;
    search.f2 = options.f2;
    const SearchReport found = SearchLandmarks(frame, search, store, session);
    growth.num_found = found.num_added;
    growth.num_united = found.num_united;
  }
  {
    const auto scope = MeasureStage(times, "triangulate");
    growth.num_created = TriangulateTracks(frame, triangulate, session).num_created;
  }
  const auto scope = MeasureStage(times, "adjust_locally");
  growth.num_pruned = AdjustLocally(frame, options, session).num_observations;
  return growth;
}

Session* RejoinFrame(const FrameEvent& event, const PlaceMatch& place, const MapperOptions& options,
                     const FrameStore& store, StageTimes* times, const SiblingsOf& siblings_of,
                     SessionTable* sessions) {
  std::vector<std::pair<TrackOfFeature, Session*>> ranked;
  for (const auto& [id, session] : sessions->all()) {
    if (!(session->drive() == event.id.drive)) continue;
    TrackOfFeature shown = LandmarksShown(event, place, *session);
    if (!shown.empty()) ranked.emplace_back(std::move(shown), session.get());
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first.size() > b.first.size(); });
  // What siblings lend may disagree where their maps do not quite meet: it comes second.
  for (const bool lends : {false, true}) {
    for (const auto& [shown, session] : ranked) {
      const std::vector<Sibling> siblings = lends ? siblings_of(*session) : std::vector<Sibling>{};
      if (lends && siblings.empty()) continue;
      if (event.kind == FrameKind::kLight) {
        if (RejoinLightFrame(event, options, siblings, session)) return session;
      } else if (RejoinKeyframe(event, place, shown, options, siblings, session)) {
        GrowMap(event.id.index, options, store, times, session);
        return session;
      }
    }
  }
  return nullptr;
}

}  // namespace rovio_sfm
