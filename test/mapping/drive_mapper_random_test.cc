// Drives at random, with everything that may go wrong in them: the invariants hold after every
// event, and whatever is mapped is mapped truly.

#include <gtest/gtest.h>

#include "mapping/mapped_drive.h"
#include "rovio_sfm/mapping/drive_mapper.h"

namespace rovio_sfm {
namespace {

constexpr SyntheticMotion kMotions[] = {SyntheticMotion::kSideways, SyntheticMotion::kForward,
                                        SyntheticMotion::kCircle};

SyntheticDriveOptions RandomDrive(uint64_t seed) {
  Rng rng(seed);
  SyntheticDriveOptions options;
  options.world.seed = seed;
  options.world.motion = kMotions[rng.UniformInt(3)];
  options.world.num_cams = 26;
  options.world.num_points = 500;
  options.world.depth = 6.0;
  options.world.step = rng.Uniform(0.1, 0.25);
  options.world.noise_px = rng.Uniform(0.0, 1.0);
  options.light_frames = static_cast<int>(rng.UniformInt(2));
  options.track_length = rng.UniformInt(2) == 0 ? 0 : 8;
  options.with_links = rng.UniformInt(2) == 0;
  options.with_late_links = rng.UniformInt(2) == 0;
  for (uint32_t i = 0; i < 26; ++i) {
    if (rng.UniformInt(25) == 0) options.blind.insert(i);
  }
  if (rng.UniformInt(3) == 0) options.cut = 8 + rng.UniformInt(4);
  if (rng.UniformInt(2) == 0) options.metres_per_unit = 0.5;
  return options;
}

// Loses, repeats and swaps some events.
std::vector<FrameEvent> Disorder(std::vector<FrameEvent> events, Rng& rng) {
  std::vector<FrameEvent> disordered;
  for (const FrameEvent& event : events) {
    if (rng.UniformInt(20) == 0) continue;
    disordered.push_back(event);
    if (rng.UniformInt(20) == 0) disordered.push_back(event);
    if (rng.UniformInt(20) == 0 && disordered.size() > 1) {
      std::swap(disordered.back(), disordered[disordered.size() - 2]);
    }
  }
  return disordered;
}

// A bootstrap from noisy data may be coarse; a wrong map is off by the size of the drive.
void ExpectTrue(const Session& session, const SyntheticWorld& world, uint64_t seed) {
  const auto error = MeasureTrajectory(session.Snapshot(), world);
  if (!error) return;
  EXPECT_LT(error->max_distance, 0.15) << "seed " << seed << ", " << error->num_frames << " frames";
}

// Returns how many keyframes and light frames were mapped.
size_t MapAtRandom(uint64_t seed) {
  const SyntheticDrive drive = MakeSyntheticDrive(RandomDrive(seed));
  MemoryFrameStore store;
  Executor executor(0);
  SessionTable table;
  MapperContext context;
  context.store = &store;
  context.sessions = &table;
  context.executor = &executor;
  context.on_session_closed = [](Session*) {};
  DriveMapper mapper(context, drive.events[0].id.drive, drive.world.camera);
  Rng rng(seed + 1000);
  for (const FrameEvent& event : Disorder(drive.events, rng)) {
    mapper.Add(event);
    for (const auto& [id, session] : table.all()) EXPECT_EQ(CheckInvariants(*session), "") << seed;
    if (rng.UniformInt(60) == 0) mapper.Finish();
  }
  mapper.Finish();
  size_t num_mapped = 0;
  for (const auto& [id, session] : table.all()) {
    EXPECT_EQ(CheckInvariants(*session), "") << seed;
    ExpectTrue(*session, drive.world, seed);
    num_mapped += session->keyframes().size() + session->light_frames().size();
  }
  return num_mapped;
}

TEST(DriveMapper, MapsRandomDrivesTruly) {
  size_t num_mapped = 0;
  for (uint64_t seed = 1; seed <= 8; ++seed) num_mapped += MapAtRandom(seed);
  EXPECT_GT(num_mapped, 100u);  // of 208
}

}  // namespace
}  // namespace rovio_sfm
