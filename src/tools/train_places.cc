#include "rovio_sfm/tools/train_places.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <opencv2/core.hpp>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "rovio_sfm/app/output_folder.h"
#include "rovio_sfm/app/place_model_file.h"
#include "rovio_sfm/app/progress_bar.h"
#include "rovio_sfm/tools/list_images.h"
#include "rovio_sfm/tools/train_place_model.h"
#include "rovio_sfm/util/check_options.h"
#include "rovio_sfm/util/count_text.h"
#include "rovio_sfm/util/parse_arguments.h"
#include "rovio_sfm/util/steady_clock.h"
#include "rovio_sfm/util/stop_signals.h"

namespace rovio_sfm {
namespace {

constexpr uintmax_t kBytesOfWord = 1024;  // in the model and in what is kept on the way

struct Arguments {
  std::vector<std::string> images;
  std::string out;
  size_t num_images = 0;  // 0: all
  int num_threads = 2;
  bool resume = false;
  bool overwrite = false;
  TrainPlacesOptions options;
};

// A bar for each step, one below the other.
class StepBars {
 public:
  explicit StepBars(std::ostream* out) : out_(out) {}

  void Show(const std::string& step, size_t done, size_t total) {
    if (step != step_) {
      step_ = step;
      start_s_ = SteadySeconds();
      bar_ = ProgressBar(total, out_);
      *out_ << step << '\n';
    }
    const double elapsed_s = SteadySeconds() - start_s_;
    if (done >= total) {
      bar_.Finish(elapsed_s);
    } else {
      bar_.Show(done, elapsed_s);
    }
  }

 private:
  std::ostream* out_;
  std::string step_;
  double start_s_ = 0.0;
  ProgressBar bar_{0, nullptr};
};

void Declare(Arguments* arguments, CLI::App* app) {
  TrainPlacesOptions& options = arguments->options;
  app->add_option("images", arguments->images, "images, or folders of images")->required();
  app->add_option("--out", arguments->out, "the model's file")->required();
  app->add_option("--words", options.cluster.num_words, "size of the vocabulary");
  app->add_option("--images", arguments->num_images, "only the first so many images; 0: all");
  app->add_option("--features", options.frontend.extract.max_features, "most of an image");
  app->add_option("--iterations", options.cluster.max_iterations, "most of k-means");
  app->add_option("--p-z-given-e", options.p_z_given_e,
                  "p(z=1|e=1) of the detector; 0: as measured on second looks");
  app->add_option("--seed", options.seed, "of everything random");
  app->add_option("--threads", arguments->num_threads, "never changes the result")
      ->check(CLI::Range(0, 256));
  app->add_flag("--resume", arguments->resume, "go on where an earlier run stopped");
  app->add_flag("--overwrite", arguments->overwrite, "replace the model's file");
}

std::vector<std::filesystem::path> ChooseImages(const Arguments& arguments) {
  std::vector<std::filesystem::path> images = ListImages(arguments.images);
  if (arguments.num_images > images.size()) {
    throw std::runtime_error("--images " + std::to_string(arguments.num_images) + ": only " +
                             std::to_string(images.size()) + " are there");
  }
  if (arguments.num_images > 0) images.resize(arguments.num_images);
  return images;
}

// Cheap now, vexing after an hour's work.
void CheckArguments(const Arguments& arguments) {
  std::string error;
  if (!IsValid(arguments.options, &error)) throw std::runtime_error(error);
  if (!arguments.overwrite && std::filesystem::exists(arguments.out)) {
    throw std::runtime_error(arguments.out + " exists; give --overwrite to replace it");
  }
}

void PrepareFolder(const Arguments& arguments) {
  RequireWritableFolder(std::filesystem::absolute(arguments.out).parent_path(),
                        kBytesOfWord * static_cast<uintmax_t>(arguments.options.cluster.num_words));
}

// What was reached is kept, file by file; threads and all end with the program.
void EndAtSignal(const std::string& work_folder, std::ostream& out) {
  if (!IsStopRequested()) return;
  out << "\nstopped by a signal; what was reached is kept in " << work_folder
      << ": go on with --resume" << std::endl;
  std::_Exit(StatusOfStop());
}

void Report(const TrainingResult& result, const std::filesystem::path& path, std::ostream& out) {
  out << result.model.provenance
      << "\nk-means: " << CountText(static_cast<uint64_t>(result.num_iterations), "iteration")
      << ", features " << result.rms_distance << " from their words (root mean square)"
      << "\nwords seen again by a second look: " << 100.0 * result.detector.seen_again
      << " %; beyond chance p(z=1|e=1) = " << result.detector.p_z_given_e << ", used "
      << result.model.detector.p_z_given_e << '\n'
      << std::filesystem::absolute(path).string() << ": " << std::filesystem::file_size(path)
      << " bytes\n";
}

}  // namespace

int TrainPlacesCommand(int argc, const char* const* argv, std::ostream& out) {
  CLI::App app("Learns what place recognition needs from photographs: words, tree, detector");
  Arguments arguments;
  Declare(&arguments, &app);
  if (const auto status = ParseArguments(&app, argc, argv, out)) return *status;
  CheckArguments(arguments);
  const std::vector<std::filesystem::path> images = ChooseImages(arguments);
  PrepareFolder(arguments);
  cv::setNumThreads(1);  // the threads are ours
  Executor executor(arguments.num_threads);
  StepBars bars(&out);
  const std::string work_folder = std::filesystem::absolute(arguments.out + ".work").string();
  const TrainingCheckpoint checkpoint(work_folder);
  const TrainingResult result =
      TrainPlaces(images, arguments.options, checkpoint, arguments.resume, &executor,
                  [&](const std::string& step, size_t done, size_t total) {
                    bars.Show(step, done, total);
                    EndAtSignal(work_folder, out);
                  });
  SavePlaceModel(result.model, arguments.out,
                 arguments.overwrite ? Overwrite::kAllow : Overwrite::kRefuse);
  Report(result, arguments.out, out);
  return 0;
}

}  // namespace rovio_sfm
