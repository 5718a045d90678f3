#include "rovio_sfm/sim/tour/render_tour.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "rovio_sfm/sim/robot/robot_body.h"
#include "rovio_sfm/sim/tour/find_overlaps.h"
#include "rovio_sfm/sim/tour/sample_surface.h"
#include "rovio_sfm/sim/tour/simulate_tour.h"
#include "rovio_sfm/sim/tour/tour_folder.h"
#include "rovio_sfm/sim/world/load_world.h"
#include "rovio_sfm/util/executor.h"
#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm::sim {
namespace {

constexpr int kDepthStep_px = 8;

TourSpec LoadTourOf(const RenderTourOptions& options, const std::string& name) {
  return WithLongerSteps(LoadTour(options.config_folder + "/tours/" + name + ".yaml"),
                         options.steps);
}

SimulatedTour Simulate(const RenderTourOptions& options, const TourSpec& spec) {
  SimulatedTour tour = SimulateTour(spec, options.slip, options.seed);
  const size_t limit = static_cast<size_t>(options.max_frames);
  if (limit > 0 && tour.frames.size() > limit) tour.frames.resize(limit);
  return tour;
}

// A data set to write: the pictures of one rendering, developed in one way.
struct Output {
  TourFolder folder;
  DevelopOptions develop;
};

std::vector<Output> OpenOutputs(const RenderTourOptions& options) {
  std::vector<Output> outputs{{TourFolder(options.out_folder, options.overwrite), options.develop}};
  if (options.clean_out_folder.empty()) return outputs;
  DevelopOptions clean = options.develop;
  clean.noise_sigma = 0.0;
  outputs.push_back({TourFolder(options.clean_out_folder, options.overwrite), clean});
  return outputs;
}

void RenderFrame(const ImageRenderer& renderer, const Movers& movers, const TourFrame& frame,
                 const std::vector<Output>& outputs, size_t index, uint64_t seed) {
  const cv::Mat light = renderer.Render(frame.motion, seed, movers.At(frame.time_s));
  for (const Output& output : outputs) {
    const cv::Mat picture = DevelopImage(light, frame.exposure, output.develop, seed);
    output.folder.WriteImage(index, EncodeJpeg(picture, output.develop));
  }
}

void RenderImages(const RenderTourOptions& options, const ImageRenderer& renderer,
                  const Movers& movers, const SimulatedTour& tour,
                  const std::vector<Output>& outputs) {
  Executor executor(options.num_threads > 1 ? options.num_threads : 0);
  Rng rng(options.seed ^ 0x70697865ULL);
  TaskGroup<void> frames(&executor);
  for (size_t i = 0; i < tour.frames.size(); ++i) {
    const uint64_t seed = rng.Next();
    const TourFrame& frame = tour.frames[i];
    frames.Add([&renderer, &movers, &frame, &outputs, seed, i] {
      RenderFrame(renderer, movers, frame, outputs, i, seed);
    });
  }
  while (frames.NumPending() > 0) frames.TakeNext();
}

// Each pair list under the name of its file.
using NamedOverlaps = std::vector<std::pair<std::string, std::vector<ViewOverlap>>>;

NamedOverlaps FindAllOverlaps(const RenderTourOptions& options, const World& world,
                              const Camera& camera, const TourSpec& spec,
                              const SimulatedTour& tour) {
  const std::vector<DepthView> views = RenderDepths(world, camera, tour, kDepthStep_px);
  NamedOverlaps overlaps{{"overlaps.txt", FindOverlaps(camera, views, kDepthStep_px)}};
  for (const std::string& name : spec.shares_with) {
    const SimulatedTour other = Simulate(options, LoadTourOf(options, name));
    const std::vector<DepthView> others = RenderDepths(world, camera, other, kDepthStep_px);
    overlaps.emplace_back("overlaps_" + name + ".txt",
                          FindOverlaps(camera, views, others, kDepthStep_px));
  }
  return overlaps;
}

void WriteCalibrations(const RenderTourOptions& options, const Camera& camera,
                       const TourFolder& folder) {
  if (!options.errs_in_calibration) return folder.WriteCalibration("calibration.txt", camera);
  Rng rng(options.seed ^ 0x6c656e73ULL);
  folder.WriteCalibration("calibration.txt", DrawCalibration(camera, rng));
  folder.WriteCalibration("calibration_true.txt", camera);
}

}  // namespace

bool RenderTourOptions::IsValid(std::string* error) const {
  OptionChecker check("render_tour", error);
  check.True("tour", !tour.empty() && tour.find('/') == std::string::npos, "the name of a tour");
  check.True("out_folder", !out_folder.empty(), "a folder");
  check.Range("max_frames", max_frames, 0, 100000);
  check.Range("steps", steps, 0.1, 10.0);
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
  const std::vector<Output> outputs = OpenOutputs(options);
  const World world(
      InLight(LoadWorld(options.config_folder + "/worlds/" + spec.world + ".yaml"), options.light));
  const Camera camera = RovioCamera();
  const ImageRenderer renderer(world, camera, options.render);
  const Movers movers = options.has_movers ? LoadMovers(spec, options.config_folder) : Movers();
  RenderImages(options, renderer, movers, tour, outputs);
  const NamedOverlaps overlaps = FindAllOverlaps(options, world, camera, spec, tour);
  for (const Output& output : outputs) {
    WriteCalibrations(options, camera, output.folder);
    for (const auto& [name, pairs] : overlaps) output.folder.WriteOverlaps(name, pairs);
    output.folder.WriteFrames(tour);
  }
  return static_cast<int>(tour.frames.size());
}

size_t WriteTourSurface(const RenderTourOptions& options) {
  std::string error;
  if (!options.IsValid(&error)) throw std::runtime_error(error);
  if (std::filesystem::exists(options.out_folder) && !options.overwrite) {
    throw std::runtime_error(options.out_folder + " exists: not overwritten");
  }
  const TourSpec spec = LoadTourOf(options, options.tour);
  const World world(LoadWorld(options.config_folder + "/worlds/" + spec.world + ".yaml"));
  const ImageRenderer renderer(world, RovioCamera(), options.render);
  const std::vector<SurfaceSample> samples =
      SampleSurface(renderer, Simulate(options, spec), options.develop, {});
  std::ofstream file(options.out_folder, std::ios::binary);
  file << SurfacePlyBytes(samples, world.spec()) << std::flush;
  if (!file) throw std::runtime_error(options.out_folder + ": cannot be written");
  return samples.size();
}

}  // namespace rovio_sfm::sim
