#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rovio_sfm/io/map_store_database.h"
#include "rovio_sfm/io/map_store_frames.h"
#include "rovio_sfm/io/map_store_journal.h"
#include "rovio_sfm/scene/session.h"

namespace rovio_sfm {

// The tables of sessions: poses, tracks, landmarks and the journal by which merges are undone.
// Throws StoreError; thread-compatible.
class StoredSessions {
 public:
  StoredSessions(StoreDatabase* database, StoredFrames* frames)
      : database_(database), frames_(frames) {}

  // Writes what changed since the last call; frames must have been put.
  void Put(Session* session);

  // Throws where the tables contradict themselves, with the session and what is wrong; or, where
  // they are given a place, leaves such sessions out and says so there.
  std::vector<SessionRecord> Read(const FrameMaker& make,
                                  std::vector<std::string>* unreadable = nullptr);

 private:
  struct Kept {
    std::optional<uint64_t> revision;
    std::map<uint32_t, EpochSizes> epochs;  // by mark
  };

  void Forget(SessionId id);
  void PutRow(const Session& session, int64_t drive);
  void PutCameras(const Session& session);
  void PutPose(const Session& session, int64_t drive, uint32_t index);
  void PutTracks(const Session& session, int64_t drive, const UnsavedParts& unsaved);
  void PutEpochs(const Session& session, Kept* kept);
  std::vector<SessionId> ReadIds() const;
  SessionRecord ReadSession(SessionId id, const FrameMaker& make) const;
  void ReadKeyframes(const FrameMaker& make, SessionRecord* record) const;
  void ReadLightFrames(const FrameMaker& make, SessionRecord* record) const;
  void ReadPoints(SessionRecord* record) const;
  void ReadCameras(SessionRecord* record) const;
  void ReadEpochs(const FrameMaker& make, SessionRecord* record) const;
  FrameEvent BareEvent(const DriveId& drive, uint32_t index) const;

  StoreDatabase* database_;
  StoredFrames* frames_;
  std::map<SessionId, Kept> kept_;
};

}  // namespace rovio_sfm
