#pragma once

#include <map>
#include <memory>
#include <vector>

#include "rovio_sfm/pipeline/drive_mapper.h"
#include "rovio_sfm/pipeline/events.h"
#include "rovio_sfm/pipeline/mapper_options.h"
#include "rovio_sfm/scene/frame_store.h"
#include "rovio_sfm/scene/map_snapshot.h"
#include "rovio_sfm/util/stage_times.h"

namespace rovio_sfm {

// From frame events to maps (§3.7–3.8): every drive is mapped by itself, in sessions that follow one
// another when tracking is lost. Thread-compatible: one owner calls it; the snapshots it hands out
// are immutable and may go anywhere.
class Mapper {
 public:
  // The store must outlive the mapper. Options must be valid.
  Mapper(const MapperOptions& options, FrameStore* store, StageTimes* times = nullptr);

  // Takes the next event of its drive. An event that does not fit (index not increasing, camera of
  // the drive changed) is refused, with the reason; the maps stay as they were.
  MapperReport Add(const FrameEvent& event);

  // Ends a drive: its current session gets its final adjustment and is closed. False if unknown.
  bool FinishDrive(const DriveId& drive);
  // Ends every drive that is still open.
  void Finish();

  // Closes the drive's current session now and opens the next with its next frame.
  bool StartSession(const DriveId& drive);

  std::shared_ptr<const MapSnapshot> Snapshot() const;
  MapperCounters counters() const;

 private:
  MapperOptions options_;
  FrameStore* store_;
  StageTimes* times_;
  uint32_t next_session_ = 1;
  std::map<DriveId, std::unique_ptr<DriveMapper>> drives_;
  mutable uint64_t version_ = 0;
};

}  // namespace rovio_sfm
