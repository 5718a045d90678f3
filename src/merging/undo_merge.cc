#include "rovio_sfm/merging/undo_merge.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/mapping/register_frame.h"
#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

bool IsOf(const MergeEdit& edit, SessionId id) {
  return edit.report.query_session == id || edit.report.other_session == id;
}

bool JoinsTwoSessions(const MergeEdit& edit) {
  return !(edit.report.query_session == edit.report.other_session);
}

std::vector<MergeEdit*> InOrderOfAcceptance(MergeList* list) {
  std::vector<MergeEdit*> accepted;
  for (MergeEdit& edit : list->edits()) {
    if (edit.IsAccepted()) accepted.push_back(&edit);
  }
  std::sort(accepted.begin(), accepted.end(),
            [](const MergeEdit* a, const MergeEdit* b) { return a->sequence < b->sequence; });
  return accepted;
}

// Where the session as it is now lies in what it was; nothing where too little is in both.
std::optional<Sim3> BeforeFromNow(const Session& before, const Session& now) {
  std::vector<Eigen::Vector3d> points_now, points_before;
  for (const auto& [id, landmark] : before.landmarks()) {
    const auto it = now.landmarks().find(id);
    if (it == now.landmarks().end()) continue;
    points_now.push_back(it->second.position);
    points_before.push_back(landmark.position);
  }
  for (const auto& [index, frame] : before.keyframes()) {
    const auto it = now.keyframes().find(index);
    if (it == now.keyframes().end()) continue;
    points_now.push_back(OriginInA(it->second.cam_from_session));
    points_before.push_back(OriginInA(frame.cam_from_session));
  }
  return AlignPoints(points_now, points_before);
}

// The keyframes that came since, at the same place relative to the others (where that is unknown:
// in the session's gauge of now, until they are resected); returns their indices.
std::vector<uint32_t> AddLaterKeyframes(const Session& now,
                                        const std::optional<Sim3>& before_from_now,
                                        Session* restored) {
  std::vector<uint32_t> added;
  for (const auto& [index, frame] : now.keyframes()) {
    if (restored->keyframes().count(index) != 0) continue;
    Keyframe moved = frame;
    if (before_from_now) {
      moved.cam_from_session = TransformCamera(*before_from_now, frame.cam_from_session);
    }
    restored->AddKeyframe(index, std::move(moved));
    added.push_back(index);
  }
  return added;
}

// The observations that only later frames have, by the track that they are in now.
std::map<TrackId, std::vector<Observation>> LaterObservations(const Landmark& landmark,
                                                              const std::set<uint32_t>& later,
                                                              const Session& restored) {
  std::map<TrackId, std::vector<Observation>> observations;
  for (const Observation& observation : landmark.observations) {
    if (later.count(observation.frame) == 0) continue;
    const TrackId track = restored.keyframe(observation.frame).tracks[observation.feature];
    if (track != 0) observations[track].push_back(observation);
  }
  return observations;
}

void AddLaterLandmarks(const Session& now, const std::vector<uint32_t>& later,
                       const Sim3& before_from_now, Session* restored) {
  const std::set<uint32_t> frames(later.begin(), later.end());
  for (const auto& [id, landmark] : now.landmarks()) {
    for (const auto& [track, observations] : LaterObservations(landmark, frames, *restored)) {
      if (restored->landmarks().count(track) != 0) {
        for (const Observation& o : observations) restored->AddObservation(track, o);
      } else if (observations.size() >= 2) {
        restored->AddLandmark(track, before_from_now * landmark.position, landmark.color,
                              observations);
      }
    }
  }
}

}  // namespace

UndoPlan PlanUndo(SessionId id, MergeList* list) {
  UndoPlan plan;
  std::set<SessionId> touched;
  for (MergeEdit* edit : InOrderOfAcceptance(list)) {
    const bool is_meant = JoinsTwoSessions(*edit) && IsOf(*edit, id);
    const bool is_touched = touched.count(edit->report.query_session) != 0 ||
                            touched.count(edit->report.other_session) != 0;
    if (!is_meant && !is_touched) continue;
    (is_meant ? plan.undone : plan.repeated).push_back(edit);
    for (const auto& [session, mark] : edit->marks) {
      touched.insert(session);
      plan.marks.try_emplace(session, mark);
    }
  }
  return plan;
}

void RestoreSession(uint32_t mark, const MapperOptions& options, Session* session) {
  Session now = *session;
  ROVIO_CHECK(now.SetCamera(now.given_camera()), "the frames came with it");
  session->RestoreTo(mark);
  const std::optional<Sim3> before_from_now = BeforeFromNow(*session, now);
  const std::vector<uint32_t> later = AddLaterKeyframes(now, before_from_now, session);
  if (before_from_now) AddLaterLandmarks(now, later, *before_from_now, session);
  for (const uint32_t index : later) {
    if (session->keyframe(index).weak) continue;
    const auto registration = RegisterAgain(index, options, *session);
    if (registration) {
      session->SetPose(index, registration->cam_from_session);
    } else if (!before_from_now) {
      session->SetWeak(index, true);
    }
  }
  for (const auto& [index, frame] : now.light_frames()) {
    const bool is_new = session->light_frames().count(index) == 0;
    if (is_new && session->keyframes().count(frame.reference) != 0) {
      session->AddLightFrame(index, frame);
    }
  }
}

}  // namespace rovio_sfm
