// Keeping all maps on disk, and taking them from there.

#include <utility>

#include "rovio_sfm/merging/map_keeper.h"

namespace rovio_sfm {

void MapKeeper::PutInto(MapStore* store) {
  for (const auto& [id, session] : sessions_.all()) store->sessions().Put(session.get());
  store->merges().PutEdits(list_.edits());
  store->merges().PutGauges(list_.num_accepted(), list_.revisions(), list_.separated());
  store->merges().PutWaiting(waiting_.All());
}

void MapKeeper::Restore(std::vector<SessionRecord> sessions, MergeRecord merges) {
  for (SessionRecord& record : sessions) {
    const Session& session = sessions_.Adopt(Session(std::move(record)));
    const std::string broken = CheckInvariants(session);
    if (broken.empty()) continue;
    throw StoreError("session " + std::to_string(session.id().value) + ": " + broken);
  }
  for (PlaceMatch& match : merges.waiting) {
    waiting_.Add({std::move(match), 0, "", false}, [](const WaitingMatch&) {});
  }
  list_.Restore(std::move(merges));
  for (const MapId map : list_.LinkedMaps()) {
    shared_[map] = std::make_shared<const SharedLandmarks>(
        FindSharedLandmarks(list_.SessionsOf(map, &sessions_), list_.LinksOf(map), options_));
  }
  for (const MergeEdit& edit : list_.edits()) {
    const bool was_running = edit.IsMerge() && !edit.report.error_after_px;
    if (was_running) AdjustAgain(list_.PlaceOf(edit.report.query_session).map);
  }
}

}  // namespace rovio_sfm
