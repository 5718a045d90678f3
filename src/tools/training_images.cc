#include "rovio_sfm/tools/training_images.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "rovio_sfm/frontend/prepare_image.h"
#include "rovio_sfm/tools/read_picture.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMaxAhead = 32;  // images in work

struct TwoLooks {
  std::string fault;  // why the image cannot be used; empty: it can
  Descriptors first;
  Descriptors second;  // empty where no second look was asked for
};

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
  const DecodeResult picture = ReadPicture(path, frontend.max_pixels);
  if (picture.bgr.empty()) return {picture.reason, {}, {}};
  TwoLooks looks{"", DescribeImage(picture.bgr, frontend), {}};
  if (second_look == nullptr) return looks;
  looks.second = DescribeImage(TakeSecondLook(picture.bgr, *second_look, rng), frontend);
  return looks;
}

void Take(TwoLooks looks, bool looked_twice, TrainingFeatures* features) {
  if (!looks.fault.empty()) {
    TellLeftOut(looks.fault);
    return;
  }
  if (looked_twice) {
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
  TrainingFeatures features;
  TaskGroup<TwoLooks> tasks(executor);
  size_t num_taken = 0;
  for (size_t i = 0; num_taken < images.size();) {
    if (i < images.size() && tasks.NumPending() < kMaxAhead) {
      tasks.Add([&, i, image_rng = rng.Fork(i)]() mutable {
        return LookAt(images[i], frontend, i % step == 0 ? &second_look : nullptr, &image_rng);
      });
      ++i;
      continue;
    }
    Take(tasks.TakeNext(), num_taken % step == 0, &features);
    progress("features", ++num_taken, images.size());
  }
  if (features.images.empty()) throw std::runtime_error("none of the images can be used");
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
