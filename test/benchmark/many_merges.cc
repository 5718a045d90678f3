// Drives through one synthetic world, joined one by one: many_merges [NUM_DRIVES] [NUM_KEYFRAMES].
// Prints for every merge what it adds to the heap and what it costs the mapper's thread, then how
// long frames of one more drive take with and without an adjustment of the whole map. Not a test.
#include <malloc.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "merging/two_drives.h"
#include "rovio_sfm/mapping/drive_mapper.h"
#include "rovio_sfm/merging/map_keeper.h"
#include "rovio_sfm/util/steady_clock.h"

namespace rovio_sfm {
namespace {

double ThreadMs() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double HeapKb() { return static_cast<double>(mallinfo2().uordblks) / 1024.0; }

// Frame i of drive k is camera num_drives * i + k of the world.
struct ManyDrives {
  ManyDrives(uint32_t drives, uint32_t keyframes) : num_drives(drives), num_keyframes(keyframes) {
    SyntheticDriveOptions options;
    options.world.num_cams = drives * keyframes;
    options.world.step = 24.0 / static_cast<double>(drives * keyframes);  // once round
    options.world.num_points = 3000;
    options.world.noise_px = 0.5;
    all = MakeSyntheticDrive(options);
    for (uint32_t cam = 0; cam < all.events.size(); ++cam) {
      FrameEvent& event = all.events[cam];
      event.id.drive.robot = "robot" + std::to_string(cam % drives);
      event.id.index = cam / drives;
      event.pairs.clear();
      store.Put(event.id, event.features);
    }
  }

  uint32_t CameraIn(uint32_t drive, uint32_t frame) const { return num_drives * frame + drive; }
  const FrameEvent& EventIn(uint32_t drive, uint32_t frame) const {
    return all.events[CameraIn(drive, frame)];
  }

  // The drive mapped without error but for the noise of its features.
  Session Map(uint32_t drive) const {
    Session session({drive + 1}, EventIn(drive, 0).id.drive, all.world.camera);
    for (uint32_t i = 0; i < num_keyframes; ++i) {
      session.AddKeyframe(
          i, MakeKeyframe(EventIn(drive, i), all.world.cams_from_map[CameraIn(drive, i)], {}));
    }
    for (const auto& [id, track] : session.tracks()) {
      if (track.members.size() < 2) continue;
      const Observation& view = track.members[0];
      const uint32_t point = all.world.views[CameraIn(drive, view.frame)][view.feature].point;
      session.AddLandmark(id, all.world.points[point], {}, track.members);
    }
    session.set_state(SessionState::kFinished);
    return session;
  }

  PairMatches PairOf(uint32_t drive, uint32_t frame) const {
    const uint32_t cam = CameraIn(drive, frame), before = CameraIn(drive, frame - 1);
    PairMatches pair;
    pair.other_index = frame - 1;
    pair.verdict = PairVerdict::kGeneral;
    pair.cam_from_other = all.world.cams_from_map[cam] * Inverse(all.world.cams_from_map[before]);
    pair.cam_from_other.translation.normalize();
    pair.inliers = TrueMatches(all.world, before, cam);
    return pair;
  }

  PlaceMatch Overlap(uint32_t a, uint32_t b, uint32_t frame) const {
    PlaceMatch match;
    match.query = EventIn(b, frame).id;
    OverlapPair pair;
    pair.other = EventIn(a, frame).id;
    pair.verdict = PairVerdict::kGeneral;
    pair.inliers = TrueMatches(all.world, CameraIn(a, frame), CameraIn(b, frame));
    match.pairs.push_back(pair);
    return match;
  }

  uint32_t num_drives, num_keyframes;
  SyntheticDrive all;
  MemoryFrameStore store;
};

// The frames of the last drive as a live mapper takes them, in wall ms; `beside` starts what runs
// beside the second half of them.
template <typename Beside>
std::vector<double> MapBeside(const ManyDrives& drives, MapKeeper* keeper, Executor* executor,
                              const Beside& beside) {
  MapperContext context;
  context.store = const_cast<MemoryFrameStore*>(&drives.store);
  context.sessions = keeper->LendSessions();
  context.executor = executor;
  context.timing = ResultTiming::kWhenReady;
  context.on_session_closed = [](Session*) {};
  const uint32_t last = drives.num_drives - 1;
  DriveMapper mapper(context, drives.EventIn(last, 0).id.drive, drives.all.world.camera);
  std::vector<double> costs_ms;
  for (uint32_t i = 0; i < drives.num_keyframes; ++i) {
    FrameEvent event = drives.EventIn(last, i);
    if (i > 0) event.pairs = {drives.PairOf(last, i)};
    if (i == drives.num_keyframes / 2) beside();
    const int64_t start_ns = SteadyNs();
    keeper->CountKeyframe();
    mapper.Add(event);
    if (i > drives.num_keyframes / 2) {
      costs_ms.push_back(1e-6 * static_cast<double>(SteadyNs() - start_ns));
    }
  }
  std::sort(costs_ms.begin(), costs_ms.end());
  return costs_ms;
}

void PrintFramesBeside(const ManyDrives& drives) {
  Executor executor{1};
  for (int run = 0; run < 5; ++run) {
    for (const bool is_adjusted : {false, true}) {
      MapKeeper keeper({}, &drives.store, &executor, ResultTiming::kWhenReady);
      for (uint32_t k = 0; k + 1 < drives.num_drives; ++k) {
        keeper.LendSessions()->Adopt(drives.Map(k));
        if (k > 0) keeper.Add(drives.Overlap(k - 1, k, drives.num_keyframes / 2));
      }
      executor.Submit([] {}).wait();
      keeper.CountKeyframe();
      const auto adjust = [&] {
        if (!is_adjusted) return;
        keeper.Unmerge({drives.num_drives - 1});
        keeper.Merge({drives.num_drives - 2}, {drives.num_drives - 1}, true);
      };
      const std::vector<double> costs_ms = MapBeside(drives, &keeper, &executor, adjust);
      std::printf("frames %s an adjustment: median %.1f ms, p95 %.1f ms\n",
                  is_adjusted ? "beside" : "without", costs_ms[costs_ms.size() / 2],
                  costs_ms[costs_ms.size() * 95 / 100]);
    }
  }
}

void JoinOneByOne(const ManyDrives& drives) {
  const double before_kb = HeapKb();
  Executor executor{0};  // solves in place: the adjustment is measured apart
  MapKeeper keeper({}, &drives.store, &executor, ResultTiming::kFixed);
  for (uint32_t k = 0; k < drives.num_drives; ++k) keeper.LendSessions()->Adopt(drives.Map(k));
  const double unmerged_kb = HeapKb() - before_kb;
  const Session& first = *keeper.sessions().Find({1});
  std::printf(
      "%u drives of %u keyframes unmerged: %.0f kB in sessions, %.0f with features; %zu "
      "features in a frame, %zu landmarks in a session\n",
      drives.num_drives, drives.num_keyframes, unmerged_kb, HeapKb(),
      first.keyframe(0).points.size(), first.landmarks().size());
  double touched = 0.0;  // keyframes, summed over merges
  for (uint32_t k = 1; k < drives.num_drives; ++k) {
    const double start_kb = HeapKb(), start_ms = ThreadMs();
    keeper.Add(drives.Overlap(k - 1, k, drives.num_keyframes / 2));
    const double merged_ms = ThreadMs();
    for (int i = 0; i < ResultDelay(size_t{drives.num_drives} * drives.num_keyframes); ++i) {
      keeper.CountKeyframe();
    }
    const double keyframes = (k + 1.0) * drives.num_keyframes;
    touched += keyframes;
    std::printf("merge %2u: %s, %.2f kB a keyframe, %.0f ms with solving, applying %.0f ms\n", k,
                ToString(keeper.Reports().back().verdict), (HeapKb() - start_kb) / keyframes,
                merged_ms - start_ms, ThreadMs() - merged_ms);
  }
  const double added_kb = HeapKb() - before_kb - unmerged_kb;
  std::printf("all merges: %.2f kB a keyframe and merge, %.1f %% of the unmerged sessions\n",
              added_kb / touched, 100.0 * added_kb / unmerged_kb);
}

}  // namespace
}  // namespace rovio_sfm

int main(int argc, char** argv) {
  const auto number = [&](int i, unsigned long fallback) {
    return static_cast<uint32_t>(argc > i ? std::strtoul(argv[i], nullptr, 10) : fallback);
  };
  const rovio_sfm::ManyDrives drives(number(1, 30), number(2, 40));
  rovio_sfm::JoinOneByOne(drives);
  rovio_sfm::PrintFramesBeside(drives);
  return 0;
}
