#include "rovio_sfm/sim/tour/sample_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rovio_sfm/sim/robot/robot_body.h"
#include "rovio_sfm/sim/world/load_world.h"
#include "sim/world/small_world.h"
#include "util/temporary_folder.h"

namespace rovio_sfm::sim {
namespace {

// A small world and the first frame of a short tour through it.
class SmallScene {
 public:
  std::vector<SurfaceSample> Sample(const std::vector<TourFrame>& frames) const {
    SimulatedTour tour = tour_;
    tour.frames = frames;
    SampleSurfaceOptions options;
    options.spacing_m = 0.1;
    options.step_px = 16;
    return SampleSurface(renderer_, tour, {}, options);
  }

  const WorldSpec& spec() const { return world_.spec(); }
  const Camera& camera() const { return renderer_.camera(); }
  const TourFrame& frame() const { return tour_.frames[0]; }

 private:
  static RenderOptions OneSample() {
    RenderOptions options;
    options.samples_per_side = 1;
    return options;
  }

  TemporaryFolder temp_;
  World world_{LoadWorld(temp_.Write("small.yaml", SmallWorldYaml()).string())};
  SimulatedTour tour_ =
      SimulateTour(LoadTour(temp_.Write("short.yaml", SmallTourYaml()).string()), SlipOptions(), 1);
  ImageRenderer renderer_{world_, RovioCamera(), OneSample()};
};

TEST(SampleSurface, IsWhatTheCamerasSeeAndCountsThem) {
  const SmallScene scene;
  const std::vector<SurfaceSample> samples = scene.Sample({scene.frame(), scene.frame()});
  ASSERT_GT(samples.size(), 20u);
  size_t seen_by_both = 0;
  for (const SurfaceSample& sample : samples) seen_by_both += sample.num_views == 2 ? 1u : 0u;
  EXPECT_GT(seen_by_both, samples.size() * 9 / 10);
  size_t on_crates = 0;
  for (const SurfaceSample& sample : samples) {
    const Eigen::Vector3f& x = sample.x_in_world;
    const Eigen::Array2f from_crate(x.x() - 2.0f,
                                    std::min(std::abs(x.y() - 1.0f), std::abs(x.y() - 2.0f)));
    const bool is_crate = (from_crate.abs() < 0.201f).all() && x.z() > 1e-4f && x.z() < 0.401f;
    EXPECT_EQ(sample.object, is_crate ? 1 : sample.object == -1 ? -1 : 0) << x.transpose();
    on_crates += is_crate ? 1u : 0u;
  }
  EXPECT_GT(on_crates, 5u);
  // Two pictures from the same place tell no depth.
  for (const SurfaceSample& sample : samples) EXPECT_GT(sample.sigma_m, 1e3f);
  const std::string bytes = SurfacePlyBytes(samples, scene.spec());
  EXPECT_EQ(bytes.size() - bytes.find("end_header\n") - 11, samples.size() * 31);
  EXPECT_NE(bytes.find("comment object 1 crate\n"), std::string::npos);
}

TEST(SampleSurface, TellsHowWellPicturesFromAsideMeasure) {
  const SmallScene scene;
  const Rigid3 first = scene.frame().world_from_camera;
  TourFrame aside = scene.frame();
  aside.world_from_camera.translation += first.rotation * Eigen::Vector3d(0.2, 0.0, 0.0);
  size_t num_seen_by_both = 0;
  for (const SurfaceSample& sample : scene.Sample({scene.frame(), aside})) {
    if (sample.num_views < 2) {
      EXPECT_TRUE(std::isinf(sample.sigma_m));
      continue;
    }
    ++num_seen_by_both;
    // Of two rays at an angle: sigma = 1 px x distance / (focal length x sine of half of it x
    // sqrt 2), with the same distance for both.
    const Eigen::Vector3d x = sample.x_in_world.cast<double>();
    const Eigen::Vector3d a = x - first.translation, b = x - aside.world_from_camera.translation;
    const double half_angle = 0.5 * std::acos(a.normalized().dot(b.normalized()));
    const double distance = 0.5 * (a.norm() + b.norm());
    const double expected = distance / (scene.camera().fx * std::sqrt(2.0) * std::sin(half_angle));
    EXPECT_NEAR(sample.sigma_m / expected, 1.0, 0.1);
  }
  EXPECT_GT(num_seen_by_both, 20u);
}

}  // namespace
}  // namespace rovio_sfm::sim
