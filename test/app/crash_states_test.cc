// A drive on a disk that loses its power at every sync, and one that fails at every call: what was
// announced as saved must be there, and mapping must go on. The quick run draws few states; with
// ROVIO_SFM_CRASH_STATES=whole (scripts/test_long crash) all that design 5.5 asks for.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <set>

#include "app/crash_checks.h"

namespace rovio_sfm {
namespace {

bool IsWhole() {
  const char* const wanted = std::getenv("ROVIO_SFM_CRASH_STATES");
  return wanted != nullptr && std::string(wanted) == "whole";
}

// What a crash leaves of each change: all that may be where they are few, else some drawn by seed.
std::vector<std::vector<uint8_t>> DrawChoices(size_t num_changes, size_t max_count, Rng& rng) {
  std::vector<std::vector<uint8_t>> all;
  size_t num_states = 1;
  for (size_t i = 0; i < num_changes && num_states <= max_count; ++i) num_states *= 3;
  for (size_t state = 0; state < std::min(num_states, max_count); ++state) {
    std::vector<uint8_t> choices(num_changes);
    size_t left = state;
    const uint32_t kind = rng.UniformInt(4);  // any, or one of them with few exceptions
    for (uint8_t& choice : choices) {
      choice = static_cast<uint8_t>(left % 3);
      left /= 3;
      if (num_states <= max_count) continue;
      const bool is_any = kind == 3 || rng.UniformInt(20) == 0;
      choice = static_cast<uint8_t>(is_any ? rng.UniformInt(3) : kind);
    }
    all.push_back(std::move(choices));
  }
  return all;
}

size_t CountSyncs() {
  size_t count = 0;
  SimulatedDisk disk;
  disk.before_sync = [&] { ++count; };
  UseSimulatedDisk(&disk);
  MapStore store(kFile, StoreAccess::kCreate, OnSimulatedDisk());
  Replay replay;
  for (const StoreCall& call : Recording().calls()) replay.Make(call, &store);
  EXPECT_EQ(replay.num_saved, 2 * RecordedDrive::kFrames) << store.error();
  return count;
}

TEST(CrashStates, TheRecordedCallsGiveTheRecordedMaps) {
  ASSERT_EQ(Recording().num_merges(), 1u);
  SimulatedDisk disk;
  UseSimulatedDisk(&disk);
  Replay replay;
  {
    MapStore store(kFile, StoreAccess::kCreate, OnSimulatedDisk());
    for (const StoreCall& call : Recording().calls()) replay.Make(call, &store);
  }
  EXPECT_EQ(FindLoss(&disk, replay), "");
  MapStore store(kFile, StoreAccess::kRead, OnSimulatedDisk());
  MapRecord record = store.Read(MakeFrames());
  ASSERT_EQ(record.sessions.size(), 2u);
  for (SessionRecord& session : record.sessions) {
    const SessionId id = session.id;
    const Session* recorded = nullptr;
    for (const StoreCall& call : Recording().calls()) {
      for (const Session& each : call.sessions) recorded = each.id() == id ? &each : recorded;
    }
    EXPECT_EQ(BytesOf(Session(std::move(session))), BytesOf(*recorded));
  }
}

// The checks must see a loss: a disk that forgets what it had synced.
TEST(CrashStates, ALossIsSeen) {
  SimulatedDisk disk;
  UseSimulatedDisk(&disk);
  Replay replay;
  Rng rng(1);
  std::unique_ptr<SimulatedDisk> early;
  MapStore store(kFile, StoreAccess::kCreate, OnSimulatedDisk());
  for (const StoreCall& call : Recording().calls()) {
    replay.Make(call, &store);
    if (replay.num_saved == 20 && early == nullptr) {
      early = disk.AfterCrash(std::vector<uint8_t>(disk.num_changes(), 1), rng);
    }
  }
  EXPECT_NE(FindLoss(early.get(), replay), "");
}

TEST(CrashStates, NothingSavedIsLostAtAnySync) {
  const size_t max_states = IsWhole() ? 200 : 6;
  const size_t num_going_on = IsWhole() ? 30 : 3;
  Rng rng(5);
  const size_t num_syncs = CountSyncs();
  std::set<size_t> going_on;
  while (going_on.size() < num_going_on) {
    going_on.insert(rng.UniformInt(static_cast<uint32_t>(num_syncs)));
  }
  SimulatedDisk disk;
  Replay replay;
  size_t sync = 0, num_states = 0;
  disk.before_sync = [&] {
    const auto all = DrawChoices(disk.num_changes(), max_states, rng);
    const bool goes_on = going_on.count(sync) != 0;
    Rng torn = rng.Fork(sync);
    const std::string wrong = InFreshProcess([&]() -> std::string {
      for (const std::vector<uint8_t>& choices : all) {
        const auto left = disk.AfterCrash(choices, torn);
        const std::string loss = FindLoss(left.get(), replay);
        if (!loss.empty()) return loss;
      }
      if (!goes_on) return "";
      const auto left = disk.AfterCrash(all[torn.UniformInt(uint32_t(all.size()))], torn);
      return FindObstacle(left.get());
    });
    EXPECT_EQ(wrong, "") << "at sync " << sync << ", " << replay.num_saved << " frames saved";
    num_states += all.size();
    ++sync;
  };
  UseSimulatedDisk(&disk);
  MapStore store(kFile, StoreAccess::kCreate, OnSimulatedDisk());
  for (const StoreCall& call : Recording().calls()) replay.Make(call, &store);
  EXPECT_EQ(sync, num_syncs);
  EXPECT_GT(num_syncs, 30u);
  std::printf("%zu syncs, %zu states, going on after %zu\n", num_syncs, num_states, num_going_on);
}

// Makes the recorded calls until the end or the first failure; its message.
std::string ReplayUntilFailure(Replay* replay) {
  try {
    MapStore store(kFile, StoreAccess::kCreate, OnSimulatedDisk());
    for (const StoreCall& call : Recording().calls()) {
      replay->Make(call, &store);
      if (!store.error().empty()) return store.error();
    }
  } catch (const StoreError& error) {
    return error.what();
  }
  return "";
}

// A disk that fails once (EIO), or from some call on (ENOSPC); then its store as that left it.
std::string FindLossAfterFailure(size_t at, bool stays, bool* has_failed) {
  size_t num_calls = 0;
  SimulatedDisk disk;
  disk.fails = [&](SimulatedDisk::Call call) {
    if (stays && call != SimulatedDisk::Call::kWrite) return false;  // reading needs no space
    const bool fails = stays ? num_calls >= at : num_calls == at;
    ++num_calls;
    *has_failed |= fails;
    return fails;
  };
  UseSimulatedDisk(&disk);
  Replay replay;
  const std::string error = ReplayUntilFailure(&replay);
  if (!error.empty() && error.rfind("map.db: ", 0) != 0) return "not clear: " + error;
  const bool is_complete = replay.num_saved == 2 * RecordedDrive::kFrames;
  if (error.empty() && !is_complete) return "a commit failed without an error";
  disk.fails = [](SimulatedDisk::Call) { return false; };
  Rng rng(at);
  for (const uint8_t choice : std::initializer_list<uint8_t>{0, 1, 2}) {
    const auto left = disk.AfterCrash(std::vector<uint8_t>(disk.num_changes(), choice), rng);
    const std::string loss = FindLoss(left.get(), replay);
    if (!loss.empty()) return loss;
  }
  return "";
}

size_t CountCalls(bool writes_alone) {
  size_t count = 0;
  SimulatedDisk disk;
  disk.fails = [&](SimulatedDisk::Call call) {
    if (!writes_alone || call == SimulatedDisk::Call::kWrite) ++count;
    return false;
  };
  UseSimulatedDisk(&disk);
  MapStore store(kFile, StoreAccess::kCreate, OnSimulatedDisk());
  Replay replay;
  for (const StoreCall& call : Recording().calls()) replay.Make(call, &store);
  return count;
}

void ExpectNothingLostByFailures(bool stays) {
  Rng rng(stays ? 8 : 9);
  const auto num_calls = static_cast<uint32_t>(CountCalls(stays));
  ASSERT_GT(num_calls, 400u);
  std::set<size_t> at;
  for (size_t i = 0; i < 200; i += IsWhole() ? 1 : 10) at.insert(i);
  for (size_t i = 0; i < (IsWhole() ? 200u : 20u); ++i) at.insert(rng.UniformInt(num_calls));
  size_t num_failed = 0;
  for (const size_t call : at) {
    bool has_failed = false;
    EXPECT_EQ(FindLossAfterFailure(call, stays, &has_failed), "") << "at call " << call;
    num_failed += has_failed ? 1 : 0;
  }
  EXPECT_EQ(num_failed, at.size());
}

TEST(CrashStates, AFullDiskLosesNothingThatWasSaved) { ExpectNothingLostByFailures(true); }

TEST(CrashStates, AFailingDiskLosesNothingThatWasSaved) { ExpectNothingLostByFailures(false); }

}  // namespace
}  // namespace rovio_sfm
