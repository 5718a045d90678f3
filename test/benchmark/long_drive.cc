// A long drive past a wall, 1000 features in each keyframe, 50 of them new, kept in a map store:
// long_drive FILE.db [NUM_KEYFRAMES]. Prints as CSV, every 50 keyframes, the resident memory,
// the CPU time that the store took per keyframe and the size on disk; then how long opening takes.
// scripts/plot_long_drive.py draws it. Not a test.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <memory>

#include "rovio_sfm/app/mapper.h"
#include "rovio_sfm/util/steady_clock.h"
#include "synthetic/synthetic_world.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kFeatures = 1000, kNewFeatures = 50, kSeen = kFeatures / kNewFeatures;
constexpr uint32_t kFramesPerCommit = 10;  // as in replay
constexpr uint32_t kFramesPerRow = 50;
constexpr double kStep = 0.05;  // map units

double ThreadMs() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double ResidentMib() {
  std::ifstream file("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1u << 20);
}

// What a store holds on disk, its log with it.
double FileMib(const std::filesystem::path& file) {
  double bytes = 0.0;
  for (const char* side : {"", "-wal"}) {
    const std::filesystem::path path = file.string() + side;
    if (std::filesystem::exists(path))
      bytes += static_cast<double>(std::filesystem::file_size(path));
  }
  return bytes / (1u << 20);
}

// Point j comes into sight in frame j / kNewFeatures and leaves it kSeen frames later.
Keypoint LookAt(uint32_t j, uint32_t index, const Camera& camera, Rng& noise) {
  Rng rng(uint64_t{j} << 8);
  const double x = kStep * (j / kNewFeatures + kSeen / 2) + rng.Uniform(-1.0, 1.0);
  const double y = rng.Uniform(-0.7, 0.7), z = rng.Uniform(3.0, 6.0);
  Keypoint keypoint;
  keypoint.x_normalized = {(x - kStep * index) / z + 0.001 * noise.Gaussian(),
                           y / z + 0.001 * noise.Gaussian()};
  const Eigen::Vector2d x_px = PixelFromNormalized(camera, keypoint.x_normalized);
  keypoint.x_px = static_cast<float>(x_px.x());
  keypoint.y_px = static_cast<float>(x_px.y());
  keypoint.size_px = 4.0f;
  return keypoint;
}

void AppendDescriptor(uint32_t j, std::vector<uint8_t>* data) {
  Rng rng(j + 77);
  for (int i = 0; i < 128; ++i) data->push_back(static_cast<uint8_t>(rng.UniformInt(80)));
}

PairMatches PairBefore(uint32_t index, uint32_t num_features) {
  PairMatches pair;
  pair.other_index = index - 1;
  pair.verdict = PairVerdict::kGeneral;
  pair.cam_from_other.translation = {-1.0, 0.0, 0.0};
  const uint32_t num_left = index < kSeen ? 0 : kNewFeatures;  // of the frame before
  for (uint32_t i = 0; i + kNewFeatures < num_features; ++i) {
    pair.inliers.push_back({i + num_left, i, 10.0f, 0.5f});
  }
  return pair;
}

FrameEvent EventAt(uint32_t index, const Camera& camera) {
  FrameEvent event;
  event.id = {{"rovio", 1000, 1}, index};
  event.stamp_ns = 1000 + index * 500'000'000LL;
  event.image_name = std::to_string(index) + ".jpg";
  event.camera = camera;
  auto features = std::make_shared<FrameFeatures>();
  features->descriptors = {DescriptorType::kSift, DescriptorMetric::kL2, 128, {}};
  Rng noise(index + 1);
  const uint32_t first = index < kSeen ? 0 : (index - kSeen + 1) * kNewFeatures;
  for (uint32_t j = first; j < (index + 1) * kNewFeatures; ++j) {
    features->keypoints.push_back(LookAt(j, index, camera, noise));
    features->colors.push_back({1, 2, 3});
    AppendDescriptor(j, &features->descriptors.data);
    event.tracks.push_back(j + 1);
  }
  event.features = std::move(features);
  const auto num_features = static_cast<uint32_t>(event.tracks.size());
  if (index > 0) event.pairs.push_back(PairBefore(index, num_features));
  return event;
}

// Counts the time that keeping frames takes.
struct TimedStore final : FrameStore {
  explicit TimedStore(MapStore* to) : store(to) {}
  void Put(const FrameEvent& event) override {
    const double start_ms = ThreadMs();
    store->Put(event);
    total_ms += ThreadMs() - start_ms;
  }
  std::shared_ptr<const FrameFeatures> Get(const FrameId& id) const override {
    const double start_ms = ThreadMs();
    auto features = store->Get(id);
    total_ms += ThreadMs() - start_ms;
    return features;
  }
  MapStore* store;
  mutable double total_ms = 0.0;
};

void MapLongDrive(const std::filesystem::path& file, uint32_t num_keyframes) {
  const Camera camera = MakeSyntheticCamera();
  MapStore store(file, StoreAccess::kCreate);
  TimedStore timed(&store);
  Executor executor{0};
  Mapper mapper({}, &timed, &executor);
  std::printf("keyframes,resident_mib,store_ms_per_keyframe,file_mib,mapper_s\n");
  const double start_ms = ThreadMs();
  for (uint32_t i = 0; i < num_keyframes; ++i) {
    mapper.Add(EventAt(i, camera));
    if ((i + 1) % kFramesPerCommit == 0) {
      const double commit_ms = ThreadMs();
      if (!mapper.SaveTo(&store)) std::printf("%s\n", store.error().c_str());
      timed.total_ms += ThreadMs() - commit_ms;
    }
    if ((i + 1) % kFramesPerRow != 0) continue;
    std::printf("%u,%.1f,%.2f,%.1f,%.1f\n", i + 1, ResidentMib(), timed.total_ms / kFramesPerRow,
                FileMib(file), 1e-3 * (ThreadMs() - start_ms));
    std::fflush(stdout);
    timed.total_ms = 0.0;
  }
  mapper.Finish();
  mapper.SaveTo(&store);
  std::fprintf(stderr, "%llu keyframes in %zu sessions\n",
               static_cast<unsigned long long>(mapper.counters().keyframes),
               mapper.Snapshot()->sessions.size());
}

void OpenAgain(const std::filesystem::path& file, uint32_t num_keyframes) {
  const int64_t start_ns = SteadyNs();
  const double start_ms = ThreadMs(), before_mib = ResidentMib();
  MapStore store(file, StoreAccess::kWrite);
  Executor executor{0};
  Mapper mapper({}, &store, &executor);
  mapper.Restore(&store);
  std::fprintf(
      stderr, "opened in %.2f s (%.2f s CPU), %.1f MiB more resident, %.1f kB on disk a keyframe\n",
      1e-9 * static_cast<double>(SteadyNs() - start_ns), 1e-3 * (ThreadMs() - start_ms),
      ResidentMib() - before_mib, 1024.0 * FileMib(file) / num_keyframes);
}

}  // namespace
}  // namespace rovio_sfm

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "long_drive FILE.db [NUM_KEYFRAMES]\n");
    return 2;
  }
  const int num_keyframes = argc > 2 ? std::atoi(argv[2]) : 2000;
  std::filesystem::remove(argv[1]);
  rovio_sfm::MapLongDrive(argv[1], static_cast<uint32_t>(num_keyframes));
  rovio_sfm::OpenAgain(argv[1], static_cast<uint32_t>(num_keyframes));
  return 0;
}
