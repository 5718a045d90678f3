#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "merging/two_drives.h"
#include "rovio_sfm/merging/map_keeper.h"

namespace rovio_sfm {

// Two perfectly mapped sessions in two gauges, ready to be merged.
struct Sessions {
  explicit Sessions(const TwoDrives& drives = MakeTwoDrives(), const MapOptions& options = {})
      : two(drives),
        store(StoreOf(two)),
        keeper(options, &store, &executor, ResultTiming::kFixed),
        a(keeper.LendSessions()->Adopt(MappedSession(two, false, {}))),
        b(keeper.LendSessions()->Adopt(MappedSession(two, true, OtherGauge()))) {
    a.set_state(SessionState::kMapping);
    b.set_state(SessionState::kMapping);
  }

  bool InOneMap() const { return keeper.PlaceOf(a.id()).map == keeper.PlaceOf(b.id()).map; }
  std::string Bytes() const { return BytesOf(a) + BytesOf(b); }
  // Until every result that is under way has come.
  void PassKeyframes() {
    for (int i = 0; i < ResultDelay(a.keyframes().size() + b.keyframes().size()); ++i) {
      keeper.CountKeyframe();
    }
  }

  TwoDrives two;
  MemoryFrameStore store;
  Executor executor{0};
  MapKeeper keeper;
  Session &a, &b;
};

inline MapOptions WithMerge(const MergeOptions& merge) {
  MapOptions options;
  options.merge = merge;
  return options;
}

// The two sessions, and a third that saw what the first saw, as a robot of its own.
struct ThreeSessions : Sessions {
  explicit ThreeSessions(const MapOptions& options = {})
      : Sessions(MakeTwoDrives(), options), c(AdoptThird()) {
    c.set_state(SessionState::kMapping);
  }

  Session& AdoptThird() {
    TwoDrives third = two;
    for (FrameEvent& event : third.a) {
      event.id.drive.robot = "third";
      store.Put(event.id, event.features);
    }
    Session session({3}, third.a[0].id.drive, two.world.camera);
    for (const auto& [index, frame] : a.keyframes()) session.AddKeyframe(index, frame);
    for (const auto& [id, landmark] : a.landmarks()) {
      session.AddLandmark(id, landmark.position, landmark.color, landmark.observations);
    }
    return keeper.LendSessions()->Adopt(std::move(session));
  }

  // Frame 8 of the third session shows what frame 8 of the second does.
  PlaceMatch OverlapOfThirdAndSecond() const {
    PlaceMatch match = TrueOverlap(two, 8, 8);
    std::swap(match.query, match.pairs[0].other);
    match.query.drive.robot = "third";
    for (FeatureMatch& inlier : match.pairs[0].inliers) std::swap(inlier.a, inlier.b);
    return match;
  }

  bool AreInOneMap(const Session& x, const Session& y) const {
    return keeper.PlaceOf(x.id()).map == keeper.PlaceOf(y.id()).map;
  }

  Session& c;
};

}  // namespace rovio_sfm
