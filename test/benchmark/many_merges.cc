// Drives through one synthetic world, joined one by one: many_merges [NUM_DRIVES] [NUM_KEYFRAMES].
// Prints for every merge a row: what it adds to the heap, and what it costs the mapper's thread
// (plot_many_merges.py draws them); then how long frames of one more session take with and without
// an adjustment of the whole map beside them. Not a test.
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <future>
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

double HeapKb() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd) / 1024.0;
}

constexpr double kFacing = 0.5;  // cosine of the angle up to which a point keeps its track

// Whether the camera sees the point from its front: as many views as a landmark of a real drive.
bool IsFacing(const SyntheticWorld& world, uint32_t cam, uint32_t point) {
  const double azimuth = 2.399963 * point;  // spread evenly
  const Eigen::Vector3d ahead =
      Inverse(world.cams_from_map[cam]).rotation * Eigen::Vector3d::UnitZ();
  return -std::sin(azimuth) * ahead.x() - std::cos(azimuth) * ahead.z() > kFacing;
}

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
      for (size_t i = 0; i < event.tracks.size(); ++i) {
        if (!IsFacing(all.world, cam, all.world.views[cam][i].point)) event.tracks[i] = 0;
      }
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

// What each of the later frames of the last drive costs a live mapper.
struct FrameCosts {
  std::vector<double> wall_ms, cpu_ms;  // rising; cpu: of the mapper's thread
};

double Percentile(const std::vector<double>& rising, size_t percent) {
  return rising[rising.size() * percent / 100];
}

// Maps the last drive as a session of its own; `beside` starts what runs beside its second half.
template <typename Beside>
FrameCosts MapBeside(const ManyDrives& drives, MapKeeper* keeper, Executor* executor,
                     const Beside& beside) {
  MapperContext context;
  context.store = const_cast<MemoryFrameStore*>(&drives.store);
  context.sessions = keeper->LendSessions();
  context.executor = executor;
  context.timing = ResultTiming::kWhenReady;
  context.on_session_closed = [](Session*) {};
  const uint32_t last = drives.num_drives - 1;
  DriveMapper mapper(context, drives.EventIn(last, 0).id.drive, drives.all.world.camera);
  FrameCosts costs;
  for (uint32_t i = 0; i < drives.num_keyframes; ++i) {
    FrameEvent event = drives.EventIn(last, i);
    if (i > 0) event.pairs = {drives.PairOf(last, i)};
    if (i == drives.num_keyframes / 2) beside();
    const int64_t start_ns = SteadyNs();
    const double start_ms = ThreadMs();
    keeper->CountKeyframe();
    mapper.Add(event);
    if (i <= drives.num_keyframes / 2) continue;
    costs.wall_ms.push_back(1e-6 * static_cast<double>(SteadyNs() - start_ns));
    costs.cpu_ms.push_back(ThreadMs() - start_ms);
  }
  std::sort(costs.wall_ms.begin(), costs.wall_ms.end());
  std::sort(costs.cpu_ms.begin(), costs.cpu_ms.end());
  return costs;
}

void PrintCosts(const char* how, const FrameCosts& costs) {
  std::printf("# frames %s an adjustment: median %.1f ms, p95 %.1f ms; of CPU %.1f and %.1f ms\n",
              how, Percentile(costs.wall_ms, 50), Percentile(costs.wall_ms, 95),
              Percentile(costs.cpu_ms, 50), Percentile(costs.cpu_ms, 95));
}

// Makes one map of all sessions, which is adjusted from when all are in it.
void JoinAll(const ManyDrives& drives, Executor* executor, MapKeeper* keeper) {
  std::promise<void> gate;
  executor->Submit([](const std::shared_future<void>& opened) { opened.wait(); },
                   gate.get_future().share());
  for (uint32_t k = 1; k < drives.num_drives; ++k) {
    keeper->Add(drives.Overlap(k - 1, k, drives.num_keyframes / 2));
  }
  gate.set_value();
}

// Beside the sessions of all drives, first apart, then joined to a map that is adjusted. One
// executor solves for the map and for the drive, as in the mapping node.
void PrintFramesBeside(const ManyDrives& drives) {
  for (const bool are_joined : {false, true}) {
    Executor executor{1};
    MapKeeper keeper({}, &drives.store, &executor, ResultTiming::kWhenReady);
    for (uint32_t k = 0; k < drives.num_drives; ++k) keeper.LendSessions()->Adopt(drives.Map(k));
    PrintCosts(are_joined ? "beside" : "without", MapBeside(drives, &keeper, &executor, [&] {
                 if (are_joined) JoinAll(drives, &executor, &keeper);
               }));
  }
}

// What sessions keep so that merges can be undone.
double JournalKb(const SessionTable& sessions) {
  size_t count = 0;
  for (const auto& [id, session] : sessions.all()) count += session->NumJournalBytes();
  return static_cast<double>(count) / 1024.0;
}

void JoinOneByOne(const ManyDrives& drives) {
  const double before_kb = HeapKb();
  StageTimes times([] { return static_cast<int64_t>(1e6 * ThreadMs()); });
  const auto adjust_ms = [&times] {
    return 1e-6 * static_cast<double>(times.totals()["adjust_map"].total_ns);
  };
  Executor executor{1};
  MapOptions options;  // solves little, in small windows: everything moves, which is what is kept
  options.adjust.running_max_iterations = 2;
  options.adjust.max_global_frames = 100;
  MapKeeper keeper(options, &drives.store, &executor, ResultTiming::kFixed, &times);
  for (uint32_t k = 0; k < drives.num_drives; ++k) keeper.LendSessions()->Adopt(drives.Map(k));
  const double unmerged_kb = HeapKb() - before_kb;
  const Session& first = *keeper.sessions().Find({1});
  std::printf("# %u drives of %u keyframes, %zu features a frame, %zu landmarks a session\n",
              drives.num_drives, drives.num_keyframes, first.keyframe(0).points.size(),
              first.landmarks().size());
  std::printf(
      "merge,keyframes,unmerged_kb,added_kb,journal_kb,merge_ms,adjust_ms,solve_s,verdict\n");
  double touched = 0.0;  // keyframes, summed over merges
  for (uint32_t k = 1; k < drives.num_drives; ++k) {
    const double start_ms = ThreadMs(), start_adjust_ms = adjust_ms();
    const int64_t start_ns = SteadyNs();
    keeper.Add(drives.Overlap(k - 1, k, drives.num_keyframes / 2));
    const double merge_ms = ThreadMs() - start_ms - (adjust_ms() - start_adjust_ms);
    for (int i = 0; i < ResultDelay(size_t{drives.num_drives} * drives.num_keyframes); ++i) {
      keeper.CountKeyframe();
    }
    const uint32_t keyframes = (k + 1) * drives.num_keyframes;
    touched += keyframes;
    std::printf("%u,%u,%.0f,%.0f,%.0f,%.1f,%.1f,%.1f,%s\n", k, keyframes, unmerged_kb,
                HeapKb() - before_kb - unmerged_kb, JournalKb(keeper.sessions()), merge_ms,
                adjust_ms() - start_adjust_ms, 1e-9 * static_cast<double>(SteadyNs() - start_ns),
                ToString(keeper.Reports().back().verdict));
  }
  const double added_kb = HeapKb() - before_kb - unmerged_kb;
  std::printf("# all merges: %.2f kB a keyframe and merge, %.1f %% of the unmerged sessions\n",
              added_kb / touched, 100.0 * added_kb / unmerged_kb);
}

}  // namespace
}  // namespace rovio_sfm

int main(int argc, char** argv) {
  const auto number = [&](int i, unsigned long fallback) {
    return static_cast<uint32_t>(argc > i ? std::strtoul(argv[i], nullptr, 10) : fallback);
  };
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const rovio_sfm::ManyDrives drives(number(1, 30), number(2, 40));
  rovio_sfm::JoinOneByOne(drives);
  for (int run = 0; run < 5; ++run) rovio_sfm::PrintFramesBeside(drives);
  return 0;
}
