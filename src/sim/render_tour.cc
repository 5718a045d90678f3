#include "rovio_sfm/sim/render_tour.h"

#include <future>
#include <stdexcept>
#include <vector>

#include "rovio_sfm/sim/find_overlaps.h"
#include "rovio_sfm/sim/load_world.h"
#include "rovio_sfm/sim/robot_body.h"
#include "rovio_sfm/sim/simulate_tour.h"
#include "rovio_sfm/sim/tour_folder.h"
#include "rovio_sfm/util/executor.h"
#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm::sim {
namespace {

constexpr int kDepthStep_px = 8;

TourSpec LoadTourOf(const RenderTourOptions& options, const std::string& name) {
  return LoadTour(options.config_folder + "/tours/" + name + ".yaml");
}

SimulatedTour Simulate(const RenderTourOptions& options, const TourSpec& spec) {
  SimulatedTour tour = SimulateTour(spec, options.slip, options.seed);
  const size_t limit = static_cast<size_t>(options.max_frames);
  if (limit > 0 && tour.frames.size() > limit) tour.frames.resize(limit);
  return tour;
}

std::vector<uint8_t> RenderFrame(const ImageRenderer& renderer, const TourFrame& frame,
                                 const DevelopOptions& develop, uint64_t seed) {
  const cv::Mat light = renderer.Render(frame.motion, seed);
  return EncodeJpeg(DevelopImage(light, frame.exposure, develop, seed), develop);
}

void RenderImages(const RenderTourOptions& options, const ImageRenderer& renderer,
                  const SimulatedTour& tour, const TourFolder& folder) {
  Executor executor(options.num_threads > 1 ? options.num_threads : 0);
  std::vector<std::future<void>> done;
  Rng rng(options.seed ^ 0x70697865ULL);
  for (size_t i = 0; i < tour.frames.size(); ++i) {
    const uint64_t seed = rng.Next();
    const TourFrame& frame = tour.frames[i];
    done.push_back(executor.Submit([&renderer, &frame, &options, &folder, seed, i] {
      folder.WriteImage(i, RenderFrame(renderer, frame, options.develop, seed));
    }));
  }
  for (std::future<void>& frame : done) frame.get();
}

std::vector<DepthView> RenderDepths(const World& world, const Camera& camera,
                                    const SimulatedTour& tour) {
  std::vector<DepthView> views;
  for (const TourFrame& frame : tour.frames) {
    views.push_back({frame.world_from_camera,
                     RenderDepth(world, camera, frame.world_from_camera, kDepthStep_px)});
  }
  return views;
}

void WriteAllOverlaps(const RenderTourOptions& options, const World& world, const Camera& camera,
                      const TourSpec& spec, const SimulatedTour& tour, const TourFolder& folder) {
  const std::vector<DepthView> views = RenderDepths(world, camera, tour);
  folder.WriteOverlaps("overlaps.txt", FindOverlaps(camera, views, kDepthStep_px));
  for (const std::string& name : spec.shares_with) {
    const SimulatedTour other = Simulate(options, LoadTourOf(options, name));
    const std::vector<DepthView> others = RenderDepths(world, camera, other);
    folder.WriteOverlaps("overlaps_" + name + ".txt",
                         FindOverlaps(camera, views, others, kDepthStep_px));
  }
}

}  // namespace

bool RenderTourOptions::IsValid(std::string* error) const {
  OptionChecker check("render_tour", error);
  check.True("tour", !tour.empty() && tour.find('/') == std::string::npos, "the name of a tour");
  check.True("out_folder", !out_folder.empty(), "a folder");
  check.Range("max_frames", max_frames, 0, 100000);
  check.Range("num_threads", num_threads, 1, 64);
  check.Nested(render);
  check.Nested(develop);
  check.Nested(slip);
  return check.Passed();
}

int RenderTour(const RenderTourOptions& options) {
  std::string error;
  if (!options.IsValid(&error)) throw std::runtime_error(error);
  const TourSpec spec = LoadTourOf(options, options.tour);
  const SimulatedTour tour = Simulate(options, spec);
  const TourFolder folder(options.out_folder, options.overwrite);
  const World world(LoadWorld(options.config_folder + "/worlds/" + spec.world + ".yaml"));
  const Camera camera = RovioCamera();
  const ImageRenderer renderer(world, camera, options.render);
  RenderImages(options, renderer, tour, folder);
  folder.WriteCalibration(camera);
  WriteAllOverlaps(options, world, camera, spec, tour, folder);
  folder.WriteFrames(tour);
  return static_cast<int>(tour.frames.size());
}

}  // namespace rovio_sfm::sim
