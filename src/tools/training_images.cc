#include "rovio_sfm/tools/training_images.h"

#include <algorithm>
#include <deque>
#include <future>
#include <stdexcept>
#include <utility>

#include "rovio_sfm/features/decode_image.h"
#include "rovio_sfm/frontend/prepare_image.h"
#include "rovio_sfm/io/text_file.h"

namespace rovio_sfm {
namespace {

constexpr uintmax_t kMaxImageBytes = 64u << 20;
constexpr size_t kMaxAhead = 32;  // images in work

struct TwoLooks {
  Descriptors first;
  Descriptors second;  // empty where no second look was asked for
};

cv::Mat ReadImage(const std::filesystem::path& path, int max_pixels) {
  DecodeResult decoded = DecodeImage(ReadBytes(path, kMaxImageBytes), max_pixels);
  if (decoded.bgr.empty()) throw std::runtime_error(path.string() + ": " + decoded.reason);
  return decoded.bgr;
}

// Only descriptors are wanted, so any camera without distortion will do.
Descriptors DescribeImage(const cv::Mat& bgr, const FrontendOptions& options) {
  Camera camera;
  camera.width = bgr.cols;
  camera.height = bgr.rows;
  camera.fx = camera.fy = bgr.cols;
  camera.cx = 0.5 * bgr.cols;
  camera.cy = 0.5 * bgr.rows;
  return FindFeatures(bgr, camera, options)->descriptors;
}

// second_look: null where one look is enough.
TwoLooks LookAt(const std::filesystem::path& path, const FrontendOptions& frontend,
                const SecondLookOptions* second_look, Rng* rng) {
  const cv::Mat bgr = ReadImage(path, frontend.max_pixels);
  TwoLooks looks{DescribeImage(bgr, frontend), {}};
  if (second_look == nullptr) return looks;
  looks.second = DescribeImage(TakeSecondLook(bgr, *second_look, rng), frontend);
  return looks;
}

void Take(TwoLooks looks, size_t step, TrainingFeatures* features) {
  if (features->images.size() % step == 0) {
    features->looked_at.push_back(static_cast<uint32_t>(features->images.size()));
    features->second_looks.push_back(std::move(looks.second));
  }
  features->images.push_back(std::move(looks.first));
}

}  // namespace

TrainingFeatures ExtractTrainingFeatures(const std::vector<std::filesystem::path>& images,
                                         const FrontendOptions& frontend,
                                         const SecondLookOptions& second_look, uint64_t seed,
                                         Executor* executor, const TrainingProgress& progress) {
  Rng rng(seed);
  const size_t max_pairs = static_cast<size_t>(second_look.max_pairs);
  const size_t step = std::max<size_t>(1, (images.size() + max_pairs - 1) / max_pairs);
  std::deque<std::future<TwoLooks>> tasks;
  TrainingFeatures features;
  for (size_t i = 0; i < images.size() || !tasks.empty();) {
    if (i < images.size() && tasks.size() < kMaxAhead) {
      tasks.push_back(executor->Submit([&, i, image_rng = rng.Fork(i)]() mutable {
        return LookAt(images[i], frontend, i % step == 0 ? &second_look : nullptr, &image_rng);
      }));
      ++i;
      continue;
    }
    Take(tasks.front().get(), step, &features);
    tasks.pop_front();
    progress("features", features.images.size(), images.size());
  }
  return features;
}

Descriptors ThinFeatures(const std::vector<Descriptors>& images, size_t max_count) {
  size_t total = 0;
  for (const Descriptors& image : images) total += image.Count();
  const size_t wanted = std::min(total, max_count);
  Descriptors thinned;
  size_t index = 0;
  for (const Descriptors& image : images) {
    if (thinned.length == 0) thinned = {image.type, image.metric, image.length, {}};
    for (size_t row = 0; row < image.Count(); ++row, ++index) {
      const bool keep = (index + 1) * wanted / total > index * wanted / total;
      if (keep) {
        thinned.data.insert(thinned.data.end(), image.Row(row), image.Row(row) + image.length);
      }
    }
  }
  return thinned;
}

}  // namespace rovio_sfm
