#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "rovio_sfm/mapping/adjust_session.h"
#include "rovio_sfm/mapping/bootstrap.h"
#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/mapping/mapper_report.h"
#include "rovio_sfm/mapping/register_frame.h"
#include "rovio_sfm/scene/drive_state.h"
#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/scene/frame_store.h"
#include "rovio_sfm/scene/place_match.h"
#include "rovio_sfm/scene/session.h"
#include "rovio_sfm/scene/session_table.h"
#include "rovio_sfm/util/executor.h"
#include "rovio_sfm/util/stage_times.h"

namespace rovio_sfm {

// What the mappers of all drives share; everything outlives them.
struct MapperContext {
  MapperOptions options;
  FrameStore* store = nullptr;
  SessionTable* sessions = nullptr;  // lent by their keeper, for the steps that are run
  Executor* executor = nullptr;      // of the global adjustment
  ResultTiming timing = ResultTiming::kFixed;
  StageTimes* times = nullptr;  // may be null
  // Of every session that ends; a linked one is still to be adjusted finally, with its map.
  std::function<void(Session*)> on_session_closed;
  // Whether links join a session's map, which then is adjusted as one; null: none does.
  std::function<bool(SessionId)> is_linked = nullptr;
};

// Maps one drive: its sessions, one after the other. Thread-compatible.
class DriveMapper {
 public:
  DriveMapper(const MapperContext& context, DriveId drive, Camera camera);
  // Goes on with a drive whose newest session is in the table; read_event gives its frames again.
  DriveMapper(const MapperContext& context, const DriveRecord& record,
              const std::function<FrameEvent(uint32_t)>& read_event);

  MapperReport Add(const FrameEvent& event);
  // Closes the current session with its final adjustment; the next frame opens another.
  void Finish();

  // Tries to start the current session from the map that its held frames see (§4.3.2); false if it
  // runs already, or cannot.
  bool Seed(const std::vector<PlaceMatch>& matches);
  // Holds all events of a drive that has none yet, for Seed; those refused are counted.
  void HoldAll(const std::vector<FrameEvent>& events);
  // True while frames wait for the current session to start, and there are this many.
  bool HoldsFrames(int min_count) const;

  SessionId current_session() const { return current_->id(); }
  DriveState State() const;  // of what lies beside its sessions
  const MapperCounters& counters() const { return counters_; }
  const Camera& camera() const { return camera_; }

 private:
  struct WeakFrame {
    FrameEvent event;
    int num_tries = 0;
  };

  Session& current() { return *current_; }
  bool IsLinked() const { return context_.is_linked && context_.is_linked(current_->id()); }
  void Settle();

  std::optional<std::string> RefusalOf(const FrameEvent& event);
  void Hold(const FrameEvent& event, MapperReport* report);
  bool Start(const BootstrapPair& pair);
  void EnterMap(uint32_t first_index);
  void InsertHeld(const FrameEvent& event);
  void AddKeyframe(const FrameEvent& event, MapperReport* report);
  std::optional<Registration> Resect(const FrameEvent& event, MapperReport* report);
  MapGrowth GrowMap(uint32_t frame);
  void AddWeak(const FrameEvent& event, MapperReport* report);
  void RetryWeakFrames(int max_tries);
  void DropKeyframe(uint32_t index);
  void LoseSession(MapperReport* report);
  MapperOutcome AddLight(const FrameEvent& event);
  void PoseWaitingLightFrames();
  void OpenSession();
  void CloseSession(SessionState state);

  MapperContext context_;
  DriveId drive_;
  Camera camera_;
  Session* current_ = nullptr;     // the drive's newest session
  uint64_t settled_revision_ = 0;  // of it, as this left it
  GlobalAdjustment global_;
  std::deque<FrameEvent> held_;  // keyframes before the session starts
  int num_waited_ = 0;           // keyframes since the first pair that would do
  std::vector<WeakFrame> weak_;  // keyframes of the current session that may yet be resected
  int num_weak_in_row_ = 0;      // of the newest keyframes
  std::vector<TrackLink> pending_links_;
  std::map<uint32_t, LightFrame> unposed_;  // light frames of the current session without a pose
  std::optional<Rigid3> last_pose_;         // cam_from_session of the last posed frame
  std::optional<uint32_t> next_index_;
  MapperCounters counters_;
};

}  // namespace rovio_sfm
