#include "rovio_sfm/tools/measure_noise.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <opencv2/core.hpp>
#include <ostream>
#include <stdexcept>

#include "rovio_sfm/tools/list_images.h"
#include "rovio_sfm/tools/read_picture.h"
#include "rovio_sfm/util/parse_arguments.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kMaxPixels = 32'000'000;
constexpr int kClippedMargin = 3;  // grey levels

// Sums over pictures, pixel by pixel and channel by channel.
struct PixelSums {
  cv::Mat sum, squared_sum;  // CV_64FC3
  double num_clipped = 0.0, num_values = 0.0;
  size_t num_pictures = 0;
};

void Add(const cv::Mat& bgr, PixelSums* sums) {
  ++sums->num_pictures;
  cv::Mat low, high, value;
  cv::inRange(bgr.reshape(1), 0, kClippedMargin, low);
  cv::inRange(bgr.reshape(1), 255 - kClippedMargin, 255, high);
  sums->num_clipped += cv::countNonZero(low) + cv::countNonZero(high);
  sums->num_values += static_cast<double>(bgr.total()) * 3.0;
  bgr.convertTo(value, CV_64FC3);
  cv::subtract(value, cv::mean(value), value);
  if (sums->sum.empty()) {
    sums->sum = cv::Mat::zeros(bgr.size(), CV_64FC3);
    sums->squared_sum = cv::Mat::zeros(bgr.size(), CV_64FC3);
  }
  sums->sum += value;
  sums->squared_sum += value.mul(value);
}

}  // namespace

NoiseReport MeasureNoise(const std::vector<std::filesystem::path>& images) {
  PixelSums sums;
  for (const std::filesystem::path& path : images) {
    const DecodeResult picture = ReadPicture(path, kMaxPixels);
    if (picture.bgr.empty()) {
      TellLeftOut(picture.reason);
      continue;
    }
    if (!sums.sum.empty() && picture.bgr.size() != sums.sum.size()) {
      throw std::runtime_error(path.string() + ": other size than the first picture");
    }
    Add(picture.bgr, &sums);
  }
  if (sums.num_pictures < 2) throw std::runtime_error("measure_noise needs two pictures or more");
  const double count = static_cast<double>(sums.num_pictures);
  const cv::Mat scatter = sums.squared_sum - sums.sum.mul(sums.sum) / count;
  const cv::Scalar variance = cv::mean(scatter / (count - 1.0));
  NoiseReport report;
  report.num_pictures = sums.num_pictures;
  for (int channel = 0; channel < 3; ++channel) {
    report.sigma_bgr[static_cast<size_t>(channel)] = std::sqrt(variance[channel]);
  }
  report.sigma = std::sqrt((variance[0] + variance[1] + variance[2]) / 3.0);
  report.clipped_share = sums.num_clipped / sums.num_values;
  return report;
}

int MeasureNoiseCommand(int argc, const char* const* argv, std::ostream& out) {
  CLI::App app("Measures a camera's noise from pictures of one flat, single-coloured surface");
  std::vector<std::string> arguments;
  app.add_option("images", arguments, "images, or folders of images")->required();
  if (const auto status = ParseArguments(&app, argc, argv, out)) return *status;
  const NoiseReport report = MeasureNoise(ListImages(arguments));
  out << "pictures " << report.num_pictures << "\nsigma " << report.sigma << " (blue "
      << report.sigma_bgr[0] << ", green " << report.sigma_bgr[1] << ", red " << report.sigma_bgr[2]
      << ") grey levels\nclipped " << 100.0 * report.clipped_share << " % of the values\n";
  return 0;
}

}  // namespace rovio_sfm
