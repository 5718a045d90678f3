#pragma once

#include <gtest/gtest.h>

#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "merging/two_drives.h"
#include "rovio_sfm/io/map_store.h"
#include "rovio_sfm/io/map_store_schema.h"
#include "rovio_sfm/mapping/drive_mapper.h"
#include "rovio_sfm/merging/map_keeper.h"

namespace rovio_sfm {

// A call on the store: a frame is put, or what changed is committed.
struct StoreCall {
  std::optional<FrameEvent> frame;
  std::vector<std::pair<DriveId, DriveState>> states;
  std::vector<Session> sessions;  // those that changed, as they were handed over
  std::deque<MergeEdit> edits;
  MergeRecord merges;
};

// Two drives of 30 frames each that merge, mapped once, as the calls on their store. A copy of
// every session's state goes with them, so that they can be made again without any mapping.
class RecordedDrive {
 public:
  static constexpr uint32_t kFrames = 30;  // of each drive

  explicit RecordedDrive(const std::filesystem::path& file)
      : store_(file, StoreAccess::kCreate), recorder_(&store_, &calls_) {
    a_.emplace(context_, two_.a[0].id.drive, two_.a[0].camera);
    b_.emplace(context_, two_.b[0].id.drive, two_.b[0].camera);
    for (uint32_t i = 0; i < kFrames; ++i) {
      for (DriveMapper* drive : {&*a_, &*b_}) {
        keeper_.CountKeyframe();
        drive->Add(drive == &*a_ ? two_.a[i] : two_.b[i]);
        keeper_.Advance();
      }
      if (i == 12) keeper_.Add(TrueOverlap(two_, 8, 8));
      CommitAll();
    }
    for (DriveMapper* drive : {&*a_, &*b_}) drive->Finish();
    keeper_.AdjustAllFinally();
    CommitAll();
  }

  const TwoDrives& two() const { return two_; }
  const std::vector<StoreCall>& calls() const { return calls_; }
  size_t num_merges() const { return keeper_.Reports().size(); }

  // Makes a call again. False: the store gave up.
  static bool Repeat(const StoreCall& call, MapStore* store) {
    if (call.frame) {
      store->Put(*call.frame);
      return store->error().empty();
    }
    std::vector<Session> sessions = call.sessions;
    return store->Commit([&] {
      for (const auto& [drive, state] : call.states) store->frames().PutState(drive, state);
      for (Session& session : sessions) store->sessions().Put(&session);
      store->merges().PutEdits(call.edits);
      const MergeRecord& merges = call.merges;
      store->merges().PutGauges(merges.num_accepted, merges.revisions, merges.separated);
      store->merges().PutWaiting(merges.waiting);
    });
  }

 private:
  // Takes down what frames come.
  struct Recorder final : FrameStore {
    Recorder(MapStore* to, std::vector<StoreCall>* all) : store(to), calls(all) {}
    void Put(const FrameEvent& event) override {
      calls->emplace_back();
      calls->back().frame = event;
      store->Put(event);
    }
    std::shared_ptr<const FrameFeatures> Get(const FrameId& id) const override {
      return store->Get(id);
    }
    MapStore* store;
    std::vector<StoreCall>* calls;
  };

  static SyntheticDriveOptions WorldOptions() {
    SyntheticDriveOptions options = TwoDrivesOptions(0.5);
    options.world.num_cams = 2 * kFrames;
    options.world.step = 0.1;
    return options;
  }

  void CommitAll() {
    StoreCall call;
    for (const DriveMapper* drive : {&*a_, &*b_}) {
      call.states.emplace_back((drive == &*a_ ? two_.a : two_.b)[0].id.drive, drive->State());
    }
    for (const auto& [id, session] : keeper_.sessions().all()) {
      if (revisions_[id] == session->revision()) continue;
      revisions_[id] = session->revision();
      call.sessions.push_back(*session);
    }
    const bool written = store_.Commit([&] {
      for (const auto& [drive, state] : call.states) store_.frames().PutState(drive, state);
      keeper_.PutInto(&store_);
    });
    if (!written) ADD_FAILURE() << store_.error();
    call.merges = MergesOnDisk();
    call.edits.assign(call.merges.edits.begin(), call.merges.edits.end());
    calls_.push_back(std::move(call));
  }
  // What the keeper keeps to itself is read where it was put.
  MergeRecord MergesOnDisk() const {
    StoreDatabase database(store_.file(), StoreAccess::kRead);
    OpenSchema(StoreAccess::kRead, &database);
    StoredFrames frames(&database);
    return StoredMerges(&database, &frames).Read();
  }

  const TwoDrives two_ = MakeTwoDrives(WorldOptions());
  std::vector<StoreCall> calls_;
  std::map<SessionId, uint64_t> revisions_;
  MapStore store_;
  Recorder recorder_;
  Executor executor_{0};
  MapOptions options_;
  MapKeeper keeper_{options_, &recorder_, &executor_, ResultTiming::kFixed};
  MapperContext context_{options_,       &recorder_,           keeper_.LendSessions(),
                         &executor_,     ResultTiming::kFixed, nullptr,
                         [](Session*) {}};
  std::optional<DriveMapper> a_, b_;
};

}  // namespace rovio_sfm
