#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "app/recorded_drive.h"
#include "io/simulated_vfs.h"
#include "rovio_sfm/app/mapper.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {

// What must hold of a map store after a crash.

constexpr char kFile[] = "map.db";

inline MapStoreOptions OnSimulatedDisk() {
  MapStoreOptions options;
  options.vfs = kSimulatedVfs;
  return options;
}

inline const RecordedDrive& Recording() {
  static const TemporaryFolder folder;
  static const RecordedDrive recording(folder.Path() / "recorded.db");
  return recording;
}

inline FrameMaker MakeFrames() {
  return {[](const FrameEvent& event) { return MakeKeyframe(event, {}, MapOptions()); },
          [](const FrameEvent& event) { return MakeLightFrame(event); }};
}

// The frames of the recording in the order in which they were put.
inline std::vector<FrameId> FramesPut() {
  std::vector<FrameId> frames;
  for (const StoreCall& call : Recording().calls()) {
    if (call.frame) frames.push_back(call.frame->id);
  }
  return frames;
}

// Calls of the recording made again; how far it came.
struct Replay {
  size_t num_put = 0;
  size_t num_saved = 0;  // of them announced as saved

  void Make(const StoreCall& call, MapStore* store) {
    if (call.frame) ++num_put;
    if (RecordedDrive::Repeat(call, store) && !call.frame) num_saved = num_put;
  }
};

inline std::string IntegrityOf(SimulatedDisk* disk) {
  if (!disk->Exists(kFile)) return "";
  StoreDatabase database(kFile, StoreAccess::kWrite, kSimulatedVfs);
  {
    Rows rows = database.Query("PRAGMA integrity_check");
    if (!rows.Next() || rows.Text(0) != "ok") return "integrity_check: " + rows.Text(0);
  }
  Rows strays = database.Query("PRAGMA foreign_key_check");
  return strays.Next() ? "foreign_key_check: " + strays.Text(0) : "";
}

// What is wrong with a disk on which the first num_saved frames were announced as saved, and those
// up to num_put may be: it is a state of before or after, never a third.
inline std::string FindLoss(SimulatedDisk* disk, const Replay& replay) {
  UseSimulatedDisk(disk);
  const std::string broken = IntegrityOf(disk);
  if (!broken.empty()) return broken;
  MapStore store(kFile, StoreAccess::kCreate, OnSimulatedDisk());
  const std::vector<FrameId> frames = FramesPut();
  size_t num_there = 0;
  for (const DriveRecord& drive : store.frames().ReadDrives()) {
    num_there += store.frames().ReadIndices(drive.id).size();
  }
  if (num_there != replay.num_saved && num_there != replay.num_put) {
    return std::to_string(num_there) + " frames are there, " + std::to_string(replay.num_saved) +
           " were saved and " + std::to_string(replay.num_put) + " put";
  }
  for (size_t i = 0; i < num_there; ++i) {
    if (!store.frames().ReadEvent(frames[i], EventParts::kAll)) {
      return "frame " + frames[i].ToString() + " is missing";
    }
  }
  for (SessionRecord& record : store.Read(MakeFrames()).sessions) {
    const std::string contradiction = CheckInvariants(Session(std::move(record)));
    if (!contradiction.empty()) return contradiction;
  }
  return "";
}

// Maps the rest of both drives on a disk that lost its power; what is wrong then.
inline std::string FindObstacle(SimulatedDisk* disk) {
  UseSimulatedDisk(disk);
  const TwoDrives& two = Recording().two();
  {
    MapStore store(kFile, StoreAccess::kCreate, OnSimulatedDisk());
    Executor executor{0};
    Mapper mapper({}, &store, &executor);
    mapper.Restore(&store);
    std::map<DriveId, uint32_t> next = mapper.NextIndices();
    for (uint32_t i = 0; i < RecordedDrive::kFrames; ++i) {
      for (const FrameEvent& event : {two.a[i], two.b[i]}) {
        if (i >= next[event.id.drive]) mapper.Add(event);
      }
      if (i == 12) mapper.Add(TrueOverlap(two, 8, 8));
    }
    mapper.Finish();
    if (!mapper.SaveTo(&store)) return store.error();
    if (mapper.counters().keyframes != 2 * RecordedDrive::kFrames) {
      return std::to_string(mapper.counters().keyframes) + " keyframes";
    }
    const auto snapshot = mapper.Snapshot();
    if (!(snapshot->sessions.at(0).map == snapshot->sessions.at(1).map)) return "two maps";
  }
  const size_t all = 2 * RecordedDrive::kFrames;
  return FindLoss(disk, {all, all});
}

// Runs a check in a process of its own, which has this one's memory and nothing else of it.
template <typename Check>
inline std::string InFreshProcess(const Check& check) {
  int ends[2];
  if (pipe(ends) != 0) return "no pipe";
  const pid_t child = fork();
  if (child == 0) {
    std::string wrong;
    try {
      wrong = check();
    } catch (const std::exception& error) {
      wrong = error.what();
    }
    const bool told = write(ends[1], wrong.data(), wrong.size()) >= 0;
    _exit(told ? 0 : 1);
  }
  close(ends[1]);
  std::string wrong(4096, ' ');
  wrong.resize(
      static_cast<size_t>(std::max<ssize_t>(0, read(ends[0], wrong.data(), wrong.size()))));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return status == 0 ? wrong : "the process ended with status " + std::to_string(status);
}

}  // namespace rovio_sfm
