#include "rovio_sfm/sim/tour/sample_surface.h"

#include <gtest/gtest.h>

#include "rovio_sfm/sim/robot/robot_body.h"
#include "rovio_sfm/sim/world/load_world.h"
#include "sim/world/small_world.h"
#include "util/temporary_folder.h"

namespace rovio_sfm::sim {
namespace {

TEST(SampleSurface, IsWhatTheCamerasSeeAndCountsThem) {
  const TemporaryFolder temp;
  const World world(LoadWorld(temp.Write("small.yaml", SmallWorldYaml()).string()));
  SimulatedTour tour =
      SimulateTour(LoadTour(temp.Write("short.yaml", SmallTourYaml()).string()), SlipOptions(), 1);
  tour.frames.resize(1);
  tour.frames.push_back(tour.frames[0]);
  RenderOptions render;
  render.samples_per_side = 1;
  const ImageRenderer renderer(world, RovioCamera(), render);
  SampleSurfaceOptions options;
  options.spacing_m = 0.1;
  options.step_px = 16;
  const std::vector<SurfaceSample> samples = SampleSurface(renderer, tour, {}, options);
  ASSERT_GT(samples.size(), 20u);
  size_t seen_by_both = 0;
  for (const SurfaceSample& sample : samples) seen_by_both += sample.num_views == 2 ? 1u : 0u;
  EXPECT_GT(seen_by_both, samples.size() * 9 / 10);
  const std::string bytes = SurfacePlyBytes(samples);
  EXPECT_EQ(bytes.size() - bytes.find("end_header\n") - 11, samples.size() * 23);
}

}  // namespace
}  // namespace rovio_sfm::sim
