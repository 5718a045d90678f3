// What each picture of a folder costs as a drive grows, in CPU seconds of the whole process on one
// thread: picture_cost DIR [NUM_PICTURES]. Prints the median of every hundred pictures, by stage
// too (adjustments of whole maps run in their picture here), and how the last pictures compare with
// early ones, beside a fixed job: a machine's speed drifts by a tenth in minutes. Not a test.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "rovio_sfm/app/offline_mapper.h"
#include "rovio_sfm/app/place_model_option.h"
#include "rovio_sfm/io/dataset_folder.h"
#include "rovio_sfm/io/text_file.h"

namespace rovio_sfm {
namespace {

constexpr size_t kWindow = 100;    // pictures that a printed line is of
constexpr size_t kEarly = 200;     // after as many pictures
constexpr size_t kCompared = 200;  // as many are compared with as many at the end

int64_t CpuNs() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1000000000LL * now.tv_sec + now.tv_nsec;
}

double Median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

using Costs = std::vector<double>;  // ms, by picture

void PrintLast(size_t count, const Costs& costs_ms, const std::map<std::string, Costs>& stages_ms) {
  const auto of_last = [count](const Costs& costs) {
    return Median({costs.end() - static_cast<ptrdiff_t>(count), costs.end()});
  };
  std::printf("pictures %zu to %zu: median %.0f ms;", costs_ms.size() - count + 1, costs_ms.size(),
              of_last(costs_ms));
  for (const auto& [stage, costs] : stages_ms) {
    std::printf(" %s %.0f", stage.c_str(), of_last(costs));
  }
  std::printf("\n");
  std::fflush(stdout);
}

// The same every time, done once beside each picture.
double FixedJobMs() {
  static const cv::Mat image = [] {
    cv::Mat noise(240, 320, CV_8UC1);
    cv::RNG(1).fill(noise, cv::RNG::UNIFORM, 0, 256);
    return noise;
  }();
  cv::Mat smooth;
  const int64_t start_ns = CpuNs();
  cv::bilateralFilter(image, smooth, 9, 50.0, 3.0);
  return 1e-6 * static_cast<double>(CpuNs() - start_ns);
}

// The medians of early pictures and of the last ones.
struct EarlyAndLate {
  explicit EarlyAndLate(const Costs& costs_ms)
      : early_ms(Median({costs_ms.begin() + kEarly, costs_ms.begin() + kEarly + kCompared})),
        late_ms(Median({costs_ms.end() - kCompared, costs_ms.end()})) {}

  double Growth() const { return late_ms / early_ms; }

  double early_ms, late_ms;
};

// How much more the last pictures of a drive cost than early ones.
void PrintGrowth(const Costs& costs_ms, const Costs& fixed_job_ms) {
  if (costs_ms.size() < kEarly + 2 * kCompared) return;
  const EarlyAndLate pictures(costs_ms), fixed(fixed_job_ms);
  std::printf("the last %zu pictures: %.0f ms, beside the %.0f ms of %zu to %zu %.2f times as much",
              kCompared, pictures.late_ms, pictures.early_ms, kEarly + 1, kEarly + kCompared,
              pictures.Growth() / fixed.Growth());
  std::printf(" by a fixed job that took %.2f and %.2f ms\n", fixed.late_ms, fixed.early_ms);
}

void Measure(const std::string& folder, size_t num_pictures) {
  cv::setNumThreads(1);
  const DatasetFolder dataset = ReadDatasetFolder(folder);
  OfflineMapperOptions options;
  options.num_threads = 1;
  StageTimes times(CpuNs);
  OfflineMapper mapper(options, ReadPlaceModel(""), &times);
  mapper.StartDrive("folder_0");
  Costs costs_ms, fixed_job_ms;
  std::map<std::string, Costs> stages_ms;
  auto before = times.totals();
  num_pictures = std::min(num_pictures, dataset.images.size());
  for (size_t i = 0; i < num_pictures; ++i) {
    ImageEvent event;
    event.stamp_ns = dataset.images[i].stamp_ns;
    event.name = dataset.images[i].name;
    event.encoded =
        std::make_shared<const std::vector<uint8_t>>(ReadBytes(dataset.images[i].path, 64u << 20));
    event.camera = dataset.camera;
    fixed_job_ms.push_back(FixedJobMs());
    const int64_t start_ns = CpuNs();
    mapper.Add(std::move(event));
    costs_ms.push_back(1e-6 * static_cast<double>(CpuNs() - start_ns));
    for (const auto& [stage, total] : times.totals()) {
      stages_ms[stage].resize(i, 0.0);
      stages_ms[stage].push_back(1e-6 *
                                 static_cast<double>(total.total_ns - before[stage].total_ns));
    }
    before = times.totals();
    const size_t num_unprinted = i % kWindow + 1;
    if (num_unprinted == kWindow || i + 1 == num_pictures) {
      PrintLast(num_unprinted, costs_ms, stages_ms);
    }
  }
  PrintGrowth(costs_ms, fixed_job_ms);
}

}  // namespace
}  // namespace rovio_sfm

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  rovio_sfm::Measure(argv[1], argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 100000);
  return 0;
}
