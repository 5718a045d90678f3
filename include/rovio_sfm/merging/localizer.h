#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "rovio_sfm/merging/map_keeper.h"
#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/scene/place_match.h"

namespace rovio_sfm {

// Where a frame stands in a map.
struct Localization {
  FrameId id;
  int64_t stamp_ns = 0;
  std::string image_name;
  std::optional<OdometrySample> odometry;
  std::optional<Rigid3> base_from_camera;
  SessionId session;  // that it sees most of
  Rigid3 cam_from_session;
  uint32_t num_matches = 0;  // features that show landmarks
  uint32_t num_inliers = 0;
};

// Poses the frames of any drive in maps that it never changes: place matches say which landmarks a
// frame shows, and the frontend's tracks carry them on to the frames that follow.
// Thread-compatible.
class Localizer {
 public:
  // Options must be valid; the keeper must outlive this.
  Localizer(const MapOptions& options, const MapKeeper* maps) : options_(options), maps_(maps) {}

  // Takes a frame; its pose where enough of its tracks show landmarks.
  std::optional<Localization> Add(const FrameEvent& event);
  // Takes what place recognition says of one of the newest frames; its pose, where that is enough.
  // A match that comes before its frame waits for it.
  std::optional<Localization> Add(const PlaceMatch& match);

  uint64_t num_frames() const { return num_frames_; }
  uint64_t num_posed() const { return num_posed_; }

 private:
  static constexpr size_t kRecentFrames = 40;  // of a drive, that a place match may come late for

  struct LandmarkRef {
    SessionId session;
    TrackId track = 0;
  };
  struct Drive {
    std::deque<FrameEvent> recent;
    std::set<uint32_t> posed;              // of them, by index
    std::map<uint32_t, PlaceMatch> early;  // by the index of frames that are not there yet
    std::map<TrackId, LandmarkRef> shown;  // by the drive's tracks
  };
  struct View {
    uint32_t feature = 0;
    LandmarkRef landmark;
  };

  std::vector<View> ViewsOf(const FrameEvent& event, const Drive& drive) const;
  std::vector<View> ViewsOf(const PlaceMatch& match) const;
  std::optional<Localization> Pose(const FrameEvent& event, const std::vector<View>& views,
                                   Drive* drive);
  void Remember(const FrameEvent& event, const std::vector<View>& views, MapId map,
                const Rigid3& cam_from_map, Drive* drive) const;
  void ForgetOldTracks(Drive* drive) const;
  const Landmark* Find(const LandmarkRef& ref) const;

  MapOptions options_;
  const MapKeeper* maps_;
  std::map<DriveId, Drive> drives_;
  uint64_t num_frames_ = 0;
  uint64_t num_posed_ = 0;
};

}  // namespace rovio_sfm
