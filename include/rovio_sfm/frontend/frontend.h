#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/frontend/choose_keyframe.h"
#include "rovio_sfm/frontend/frontend_options.h"
#include "rovio_sfm/frontend/light_tracks.h"
#include "rovio_sfm/frontend/match_recursively.h"
#include "rovio_sfm/frontend/prepare_image.h"
#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/tracks/track_builder.h"
#include "rovio_sfm/util/stage_times.h"

namespace rovio_sfm {

// What became of the images given, since the start.
struct FrontendCounters {
  uint64_t images = 0;
  uint64_t refused = 0;      // broken bytes, wrong size, bad camera
  uint64_t late = 0;         // not later than the drive's newest image, by at most a second
  uint64_t spoilt = 0;       // of one colour or far too blurred
  uint64_t featureless = 0;  // too few features for a keyframe
  uint64_t untracked = 0;    // too few features followed for a light frame
  uint64_t keyframes = 0;
  uint64_t light_frames = 0;
  uint64_t drives = 0;
  uint64_t links = 0;
  uint64_t track_matches = 0;  // verified matches that were to extend or join tracks
  uint64_t refused_f1 = 0;     // of them, by filter f1
};

// From images to frame events (§3.3–3.6). The first image starts a drive; one whose stamp lies more
// than a second before the newest, or of another camera, starts the next, which is logged. One that
// is repeated, or less late, is dropped. Results depend on images, options and seed alone. Not
// thread-safe; PrepareImage may run ahead on other threads.
class Frontend {
 public:
  // Options must be valid. nonce tells drives apart that begin at the same stamp; each further
  // drive of this frontend counts it up. times is borrowed, may be null and must outlive the
  // frontend.
  Frontend(const FrontendOptions& options, std::string robot, uint64_t seed, uint32_t nonce,
           StageTimes* times = nullptr);

  // The next image's event; nothing if it was not accepted (see counters and last_refusal).
  std::optional<FrameEvent> Add(const ImageEvent& image);
  // The same for an image that PrepareImage prepared with the same options.
  std::optional<FrameEvent> Add(const PreparedImage& image);

  // New thresholds from the next image on; drive, keyframes and tracks go on. False, with the
  // reason, if they may not follow the present ones (MayFollow); these then stay.
  bool SetOptions(const FrontendOptions& options, std::string* error);

  const FrontendOptions& options() const { return options_; }
  const FrontendCounters& counters() const { return counters_; }
  const std::string& last_refusal() const { return last_refusal_; }

 private:
  // All that ends with a drive.
  struct Drive {
    Drive(const DriveId& drive_id, const Camera& drive_camera, const FrontendOptions& options);

    DriveId id;
    Camera camera;
    uint32_t next_index = 0;
    int64_t newest_ns;  // stamp of its newest image
    KeyframeChooser chooser;
    LightTracks light;
    TrackBuilder tracks;
    std::deque<RecentKeyframe> recent;
  };

  std::optional<FrameEvent> Drop(uint64_t* counter, const std::string& reason);
  // Whether the image comes in order; where a new drive begins with it, opens that.
  bool EnsureDrive(const ImageEvent& image);
  void StartDrive(const ImageEvent& image);
  FrameEvent StartEvent(const PreparedImage& image, FrameKind kind) const;
  std::optional<FrameEvent> AddKeyframe(const PreparedImage& image);
  std::optional<FrameEvent> AddLightFrame(const PreparedImage& image);
  void LinkTracks(FrameEvent* event);
  void Remember(const RecentKeyframe& keyframe);
  void FollowFrom(const PreparedImage& image, const FrameEvent& event);

  FrontendOptions options_;
  std::string robot_;
  uint64_t seed_;
  uint32_t nonce_;
  StageTimes* times_;
  std::optional<Drive> drive_;
  FrontendCounters counters_;
  std::string last_refusal_;
};

}  // namespace rovio_sfm
