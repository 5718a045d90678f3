// Drives through one synthetic world, joined one by one: many_merges [NUM_DRIVES] [NUM_KEYFRAMES].
// Prints for every merge what it adds to the heap and what it costs the mapper's thread, then how
// long frames of one more drive take with and without an adjustment of the whole map. Not a test.
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "merging/two_drives.h"
#include "rovio_sfm/merging/map_keeper.h"

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
    options.world.step = 6.0 / static_cast<double>(drives * keyframes);
    options.world.num_points = 4000;
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

void JoinOneByOne(const ManyDrives& drives) {
  const double before_kb = HeapKb();
  Executor executor{0};  // solves in place: the adjustment is measured apart
  MapKeeper keeper({}, &drives.store, &executor, ResultTiming::kFixed);
  for (uint32_t k = 0; k < drives.num_drives; ++k) keeper.LendSessions()->Adopt(drives.Map(k));
  const double unmerged_kb = HeapKb() - before_kb;
  std::printf("%u drives of %u keyframes unmerged: %.0f kB in sessions\n", drives.num_drives,
              drives.num_keyframes, unmerged_kb);
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
  rovio_sfm::JoinOneByOne(rovio_sfm::ManyDrives(number(1, 30), number(2, 40)));
  return 0;
}
