#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "rovio_sfm/io/map_store_database.h"
#include "rovio_sfm/scene/drive_state.h"
#include "rovio_sfm/scene/events.h"

namespace rovio_sfm {

// Bare: without descriptors, pairs, links and image.
enum class EventParts { kAll, kBare };

// The tables of drives and their frames. Throws StoreError; thread-compatible.
class StoredFrames {
 public:
  explicit StoredFrames(StoreDatabase* database);

  // A frame is written once: one that is there stays.
  void PutFrame(const FrameEvent& event, bool keep_image);
  void PutState(const DriveId& drive, const DriveState& state);

  // Nothing for unknown frames.
  std::optional<FrameEvent> ReadEvent(const FrameId& id, EventParts parts) const;
  std::shared_ptr<const FrameFeatures> ReadFeatures(const FrameId& id) const;
  std::shared_ptr<const std::vector<uint8_t>> ReadImage(const FrameId& id) const;
  std::vector<DriveRecord> ReadDrives() const;
  // Of a drive, in order.
  std::vector<uint32_t> ReadIndices(const DriveId& drive, uint32_t first = 0,
                                    uint32_t max_count = UINT32_MAX) const;

  // A drive's row, made where it is new; the drive of a row.
  int64_t RowOf(const DriveId& drive, const Camera& camera);
  std::optional<int64_t> FindRow(const DriveId& drive) const;
  DriveId DriveAt(int64_t row) const;  // throws where there is none
  Camera CameraAt(int64_t row) const;
  // The row of a frame: that of its drive * 2^32 + its index.
  static int64_t FrameRow(int64_t drive_row, uint32_t index) {
    return (drive_row << 32) | static_cast<int64_t>(index);
  }
  static uint32_t IndexOfRow(int64_t frame_row) { return static_cast<uint32_t>(frame_row); }

 private:
  struct Drive {
    DriveId id;
    Camera camera;
  };

  std::optional<FrameEvent> ReadRow(const FrameId& id, int64_t row, EventParts parts) const;
  std::optional<int64_t> RowOfFrame(const FrameId& id) const;
  void PutPairs(int64_t row, const FrameEvent& event);
  std::vector<PairMatches> ReadPairs(int64_t row, size_t num_features) const;
  std::vector<TrackLink> ReadLinks(int64_t row) const;
  void ReadDescriptors(int64_t row, FrameFeatures* features) const;

  StoreDatabase* database_;
  std::map<int64_t, Drive> drives_;  // by row
  std::map<DriveId, int64_t> rows_;
};

}  // namespace rovio_sfm
