#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "rovio_sfm/app/mapper.h"
#include "rovio_sfm/app/store_folder.h"
#include "rovio_sfm/frontend/frontend.h"
#include "rovio_sfm/merging/localizer.h"
#include "rovio_sfm/recognition/place_recognizer.h"
#include "rovio_sfm/report/matching_funnel.h"
#include "rovio_sfm/report/why_no_scale.h"
#include "rovio_sfm/scene/frame_cache.h"
#include "rovio_sfm/scene/memory_frame_store.h"
#include "rovio_sfm/util/executor.h"
#include "rovio_sfm/util/option_table.h"
#include "rovio_sfm/util/reason_counts.h"
#include "rovio_sfm/util/stage_times.h"
#include "rovio_sfm/util/worker.h"

namespace rovio_sfm {

struct OfflineMapperOptions {
  FrontendOptions frontend;
  MapOptions mapper;
  PlaceRecognizerOptions places;
  // Algorithms 1 to 3 of the thesis (§4.3), in their phases: the features of all drives, the places
  // of all frames, then one session after the other, each seeded from those before.
  bool seeded = false;
  // The maps of a store stay what they are: images are only posed in them.
  bool localize = false;
  int num_threads = 2;
  uint64_t seed = 1;

  void DescribeOptions(OptionTable& table) {
    table.AddGroup("frontend", frontend, "");
    table.AddGroup("mapper", mapper, "");
    table.AddGroup("places", places, "");
    table.AddNumber("num_threads", num_threads, 1, 64, "1: the caller's; never changes the result");
  }
};

// What the mapper did to landmarks, over all frames (§3.7).
struct LandmarkCounts {
  uint64_t created = 0, united = 0;
  uint64_t pruned_observations = 0;
};

// Maps drives one after the other, without a clock: images are prepared ahead on a pool, matched
// and tracked on the caller's thread in order, and mapped on a thread of their own. The same
// images, options and seed give the same maps, whatever the number of threads.
class OfflineMapper {
 public:
  // Options must be valid. Without a place model drives are not merged, and loops not closed. times
  // and store are borrowed, may be null and must outlive the mapper. A store's maps go on: what it
  // holds of a drive is not mapped again. Throws StoreError.
  OfflineMapper(const OfflineMapperOptions& options, std::shared_ptr<const PlaceModel> place_model,
                StageTimes* times, MapStore* store = nullptr);

  // Ends the drive before, if there is one, and begins the next. It is one that the store holds
  // where its first picture and that picture's stamp are: the store's goes on.
  void StartDrive(const std::string& robot);
  // The next image of the drive; waits where too many are under way.
  void Add(ImageEvent image);
  // Maps what is under way, with `seeded` all drives; after a stop signal no longer than half of
  // what is left to end in. The snapshot is of the maps as they stand; no image may follow.
  std::shared_ptr<const MapSnapshot> Drain();
  // Drains, and ends the last drive; its snapshot is final.
  std::shared_ptr<const MapSnapshot> Finish();

  // A map of that snapshot, as exporters want it; see Mapper.
  MapModel ModelOf(const LevelMap& map) const { return mapper_.ModelOf(map); }

  // The features of its keyframes.
  const FrameStore& frames() const { return *store_; }

  // With which start, from 0, the drives of this run began; a jump of time begins another drive.
  const std::map<DriveId, size_t>& drives() const { return start_of_drive_; }

  // What became of the images of all drives so far; call after Drain or Finish.
  const FrontendCounters& frontend_counters() const { return frontend_counters_; }
  const MatchingFunnel& matching_funnel() const { return funnel_; }
  const MotionCounts& motion_counts() const { return motion_; }
  const LandmarkCounts& landmark_counts() const { return landmarks_; }
  PlaceCounters place_counters() const {
    return recognizer_ ? recognizer_->counters() : PlaceCounters();
  }
  // Why images and frames were left out.
  ReasonCounts reasons() const;
  // Frames that were lost when they came, and posed at the end.
  uint64_t num_rejoined() const { return num_rejoined_; }
  MapperCounters mapper_counters() const { return mapper_.counters(); }
  std::vector<MergeReport> merge_reports() const { return mapper_.MergeReports(); }
  // Where the images stand, with options.localize: those that were posed, by drive and index.
  const std::map<FrameId, Localization>& localizations() const { return localizations_; }

 private:
  void Resume();
  FrameStore* ChooseStore();
  DriveId NameOf(const DriveId& drive) const;
  bool IsKept(const FrameEvent& event);
  void FinishDrive();
  void TakeOldest();
  void Map(const FrameEvent& event);
  void MapSeeded();
  void MapFirst(const std::vector<FrameEvent>& events, const std::vector<PlaceMatch>& matches);
  void RejoinLost(FrameKind kind);
  void RejoinLost(FrameKind kind, const DriveId& drive, std::vector<uint32_t> lost);
  std::map<uint32_t, PlaceMatch> PlacesOf(const std::vector<uint32_t>& lost, const DriveId& drive);
  void Localize(const FrameEvent& event);
  void KeepBest(const std::optional<Localization>& pose);

  OfflineMapperOptions options_;
  StageTimes* times_;
  MapStore* kept_;  // null: in memory alone
  MemoryFrameStore memory_;
  FrameCache newest_;          // over what is kept, where nothing is added to it
  FrameStore* store_;          // one of the three
  Executor adjust_executor_;   // of the mapper's global adjustment
  Executor prepare_executor_;  // of the frontend's pure first half
  TaskGroup<PreparedImage> prepared_;
  Mapper mapper_;
  std::optional<Localizer> localizer_;
  std::map<FrameId, Localization> localizations_;
  std::optional<PlaceRecognizer> recognizer_;  // none without a place model
  std::string robot_;
  std::optional<Frontend> frontend_;             // from a drive's first image on
  std::unique_ptr<Worker<FrameEvent>> mapping_;  // null with one thread
  std::vector<std::vector<FrameEvent>> drives_;  // only where drives are seeded
  FrontendCounters frontend_counters_;
  MatchingFunnel funnel_;
  ReasonCounts dropped_, refused_;  // by the frontend, by the mapper (on its thread)
  MotionCounts motion_;
  LandmarkCounts landmarks_;  // of the mapper's thread
  uint64_t num_rejoined_ = 0;
  size_t num_starts_ = 0;
  std::map<DriveId, DriveId> names_;  // of the frontend's drives since the last start
  std::map<DriveId, size_t> start_of_drive_;
  std::set<DriveId> otherwise_kept_;         // drives whose pictures there are others
  std::map<DriveId, uint32_t> kept_before_;  // the index after the last frame that the store held
  std::map<DriveId, SessionId> newest_sessions_;
};

}  // namespace rovio_sfm
