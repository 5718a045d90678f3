#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "rovio_sfm/io/map_store_database.h"
#include "rovio_sfm/io/map_store_frames.h"
#include "rovio_sfm/scene/map_record.h"

namespace rovio_sfm {

// The tables of overlaps: the list of edits that makes maps of sessions, and what waits to be
// judged. Throws StoreError; thread-compatible.
class StoredMerges {
 public:
  StoredMerges(StoreDatabase* database, StoredFrames* frames)
      : database_(database), frames_(frames) {}

  // Write what changed since the last call.
  void PutEdits(const std::deque<MergeEdit>& edits);
  void PutGauges(uint32_t num_accepted, const std::map<MapId, uint32_t>& revisions,
                 const std::set<std::pair<SessionId, SessionId>>& separated);
  void PutWaiting(const std::vector<PlaceMatch>& waiting);

  MergeRecord Read();

 private:
  // What of an edit may change; its place match never does.
  struct Face {
    MergeReport report;
    uint32_t sequence;
    std::map<SessionId, uint32_t> marks;
    LinkList links;
  };
  using WaitingKey = std::pair<FrameId, FrameId>;  // query, first of the matched frames

  static bool IsSame(const Face& face, const MergeEdit& edit);
  static Face FaceOf(const MergeEdit& edit);
  bool AreDrivesKnown(const PlaceMatch& match) const;
  void PutEdit(const MergeEdit& edit);
  int64_t RowOf(const DriveId& drive) const;
  std::vector<MergeEdit> ReadEdits() const;
  std::vector<PlaceMatch> ReadWaiting() const;

  StoreDatabase* database_;
  StoredFrames* frames_;
  std::vector<Face> kept_edits_;  // by id
  std::vector<WaitingKey> kept_waiting_;
  uint32_t kept_accepted_ = 0;
  std::map<MapId, uint32_t> kept_revisions_;
  std::set<std::pair<SessionId, SessionId>> kept_separated_;
};

}  // namespace rovio_sfm
