#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "rovio_sfm/app/mapper.h"
#include "rovio_sfm/app/store_folder.h"
#include "rovio_sfm/merging/localizer.h"
#include "rovio_sfm/report/why_no_scale.h"
#include "rovio_sfm/scene/memory_frame_store.h"
#include "rovio_sfm/util/executor.h"
#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm {

// Where a robot's odometry touches the map: a registered frame and the odometry at it.
struct OdometryAnchor {
  SessionId session;
  uint32_t index = 0;  // FrameId::index
  std::optional<OdometrySample> odometry;
  DriveId drive = {};
  std::optional<FrameSnapshot> localized = {};  // the frame itself, where it is none of the map's
};
// A localized frame as if it were one of the session's.
FrameSnapshot FrameOf(const Localization& pose);
// The anchor's frame in its session; null if it has no pose (any more).
const FrameSnapshot* FindAnchorFrame(const SessionSnapshot& session, const OdometryAnchor& anchor);

// A session that was closed by request.
struct ClosedSession {
  SessionId id;
  bool has_frames = false;  // false: it found no first two frames
};

// What the world may see of the mapping, at one moment.
struct MapPicture {
  uint64_t number = 0;  // raised with every picture
  uint64_t epoch = 0;   // raised when all maps are forgotten: sessions are numbered anew
  std::shared_ptr<const MapSnapshot> snapshot;
  // By robot: of its newest registered frame, and of the newest that has odometry.
  std::map<std::string, OdometryAnchor> anchors, wheel_anchors;
  MapperCounters counters;
  std::map<std::string, MotionCounts> motion;  // by robot
  uint64_t num_events = 0;
  // By id; never null, and the same list as long as nothing in it changes.
  std::shared_ptr<const std::vector<MergeReport>> merges =
      std::make_shared<const std::vector<MergeReport>>();
  uint64_t num_place_matches = 0, num_matches_waiting = 0, num_matches_repeated = 0;
  std::vector<FrameId> saved_up_to;  // the newest frame of each drive that is on disk
  uint64_t num_localized = 0, num_not_localized = 0;  // frames, while maps are only read
  std::set<std::string> astray;  // robots not found in such a map since their newest frame came
  std::string store_error;       // why nothing is saved any more; empty: all is well
};

// One sentence for each robot that has posed frames but no metric scale: why.
std::vector<std::string> WhyNotMetric(const MapPicture& picture);

// The mapper of all robots with what it needs, and the rules of who may send: a robot's new drive
// ends its last one, and events of an ended drive are refused (two frontends with one name). One
// thread calls everything but Picture(), which is thread-safe.
class MappingEngine {
 public:
  // store: where the maps are kept, and taken from; null: in memory alone. Throws StoreError.
  // A store that is only read gives maps that stay what they are, in which frames are localized.
  explicit MappingEngine(const MapOptions& options, std::unique_ptr<StoreFolder> store = nullptr);

  MapperReport Add(const FrameEvent& event);
  // Takes an overlap; it waits until its frames are there. Merge reports say what became of it.
  void Add(const PlaceMatch& match);
  // In place of Add where maps are only read: where the frame, or the query of the match, stands.
  std::optional<Localization> Localize(const FrameEvent& event);
  std::optional<Localization> Localize(const PlaceMatch& match);
  bool localizes() const { return state_->localizer.has_value(); }
  // Takes over the adjustments of maps that are ready; call now and then.
  void ApplyDueResults();
  // By request, of known sessions that have frames; the report says what was done, or why not.
  MergeReport Merge(SessionId a, SessionId b, bool force);
  // b_from_a: session_<b>/map from session_<a>/map.
  MergeReport MergeAt(SessionId a, SessionId b, const Sim3& b_from_a);
  // Takes a session out of its map; returns what was undone, nothing if it was alone.
  std::vector<MergeReport> Unmerge(SessionId id);

  // The first index of the event's drive that is missing before it; its own index if none is.
  uint32_t NextIndex(const FrameId& id) const;

  // Closes the running session of a robot, and says which that was; nothing if none runs.
  std::optional<ClosedSession> FinishSession(const std::string& robot);
  void Finish();
  // Forgets all maps; drives that run go on in new sessions. Where they are on disk they stay
  // there, in the file that this returns.
  std::filesystem::path Reset();
  // Takes the maps of another store in place of these, which stay in the file that this returns.
  // Throws StoreError, and keeps the maps, where that is no store; only where one is kept.
  std::filesystem::path Load(const std::filesystem::path& other);
  bool keeps_store() const { return store_ != nullptr; }
  // All that came is on the disk when this returns; call at least once a second. Nothing where no
  // store is kept.
  void Save();

  // A map of the newest picture, as exporters want it; see Mapper.
  MapModel ModelOf(const LevelMap& map) const { return state_->mapper.ModelOf(map); }

  MapPicture Picture() const EXCLUDES(mutex_);

 private:
  // A mapper dies before what it borrows.
  struct State {
    State(const MapOptions& options, MapStore* kept)
        : mapper(options, kept == nullptr ? static_cast<FrameStore*>(&memory) : kept, &executor,
                 nullptr, ResultTiming::kWhenReady) {}
    MemoryFrameStore memory;
    Executor executor{1};  // of global adjustments
    Mapper mapper;
    std::optional<Localizer> localizer;
  };

  void Resume();
  void Anchor(const OdometryAnchor& newer);
  void Anchor(const Localization& pose);
  void BeginAnew();
  bool EnterDrive(const DriveId& drive, std::string* error);
  std::optional<SessionId> RunningSession(const DriveId& drive) const;
  void Show() EXCLUDES(mutex_);

  MapOptions options_;
  std::unique_ptr<StoreFolder> store_;  // null: none is kept
  std::unique_ptr<State> state_;
  std::vector<FrameId> saved_up_to_;
  bool is_saved_ = true;
  std::map<std::string, DriveId> current_drives_;  // by robot
  std::set<DriveId> ended_drives_;
  std::map<DriveId, uint32_t> next_indices_;
  std::map<std::string, OdometryAnchor> anchors_, wheel_anchors_;
  std::set<std::string> astray_;
  std::map<std::string, MotionCounts> motion_;
  uint64_t epoch_ = 0, num_events_ = 0, num_place_matches_ = 0;
  mutable Mutex mutex_;
  MapPicture picture_ GUARDED_BY(mutex_);
};

}  // namespace rovio_sfm
