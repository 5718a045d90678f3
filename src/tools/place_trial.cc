#include "rovio_sfm/tools/place_trial.h"

#include <algorithm>
#include <ctime>
#include <limits>
#include <map>
#include <stdexcept>

#include "rovio_sfm/frontend/prepare_image.h"
#include "rovio_sfm/places/tf_idf.h"
#include "rovio_sfm/scene/memory_frame_store.h"
#include "rovio_sfm/tools/read_picture.h"
#include "rovio_sfm/util/executor.h"

namespace rovio_sfm {
namespace {

PlaceImage ExtractPlaceImage(const PlaceImages& images, uint32_t index, uint32_t folder,
                             const FrontendOptions& options) {
  const DatasetImage& source = images.dataset.images[index];
  const DecodeResult decoded = ReadPicture(source.path, options.max_pixels);
  if (decoded.bgr.empty()) throw std::runtime_error(decoded.reason);
  PlaceImage image;
  image.name = images.dataset.path.filename().string() + "/" + source.path.filename().string();
  image.id = {{"folder_" + std::to_string(folder), folder, 0}, index};
  image.camera = images.dataset.camera;
  image.features = FindFeatures(decoded.bgr, image.camera, options);
  return image;
}

FrameEvent EventOf(const PlaceImage& image) {
  FrameEvent event;
  event.id = image.id;
  event.camera = image.camera;
  event.features = image.features;
  event.tracks.assign(image.features->keypoints.size(), 0);
  return event;
}

double ThreadCpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Sums the processor time of the calls that it wraps: the same on a busy machine.
class Stopwatch {
 public:
  template <typename Function>
  auto Measure(const Function& function) {
    const double start_s = ThreadCpuSeconds();
    auto result = function();
    total_s_ += ThreadCpuSeconds() - start_s;
    ++count_;
    return result;
  }
  double MeanMs() const { return count_ == 0 ? 0.0 : 1e3 * total_s_ / static_cast<double>(count_); }

 private:
  double total_s_ = 0.0;
  size_t count_ = 0;
};

std::optional<PlaceAnswer> BestOf(const std::vector<double>& values, double score) {
  const std::vector<uint32_t> best = BestPlaces(values, 1);
  if (best.empty()) return std::nullopt;
  return PlaceAnswer{best.front(), score};
}

// The match with most inliers.
std::optional<PlaceAnswer> BestOf(const std::vector<PlaceMatch>& matches,
                                  const std::map<FrameId, size_t>& numbers) {
  std::optional<PlaceAnswer> best;
  for (const PlaceMatch& match : matches) {
    const OverlapPair& pair = match.pairs.front();
    const auto score = static_cast<double>(pair.inliers.size());
    if (!best || score > best->score) best = PlaceAnswer{numbers.at(pair.other), score};
  }
  return best;
}

CandidateOptions OnlyTheBest() {
  CandidateOptions options;
  options.min_score = -std::numeric_limits<double>::infinity();
  options.max_candidates = 1;
  return options;
}

}  // namespace

std::vector<PlaceImage> ExtractPlaceImages(const PlaceImages& images, uint32_t folder,
                                           const FrontendOptions& options, int num_threads) {
  Executor executor(num_threads > 1 ? num_threads : 0);
  TaskGroup<PlaceImage> tasks(&executor);
  for (const uint32_t index : images.indices) {
    tasks.Add([&images, index, folder, &options] {
      return ExtractPlaceImage(images, index, folder, options);
    });
  }
  std::vector<PlaceImage> extracted;
  while (tasks.NumPending() > 0) extracted.push_back(tasks.TakeNext());
  return extracted;
}

PlaceTrial RunPlaceTrial(const std::vector<PlaceImage>& queries,
                         const std::vector<PlaceImage>& database,
                         const std::shared_ptr<const PlaceModel>& model,
                         const PlaceRecognizerOptions& options) {
  MemoryFrameStore store;
  PlaceRecognizer recognizer(options, model, &store);
  TfIdf tf_idf(*model);
  std::map<FrameId, size_t> numbers;
  for (const PlaceImage& image : database) {
    numbers[image.id] = numbers.size();
    store.Put(image.id, image.features);
    recognizer.Remember(EventOf(image));
    tf_idf.AddPlace(model->vocabulary.Quantize(image.features->descriptors));
  }
  PlaceTrial trial;
  Stopwatch words_watch, fabmap_watch, verify_watch;
  for (const PlaceImage& image : queries) {
    const auto words = words_watch.Measure(
        [&] { return model->vocabulary.Quantize(image.features->descriptors); });
    const auto proposal =
        fabmap_watch.Measure([&] { return recognizer.index().AskAll(words, OnlyTheBest()); });
    trial.fabmap.push_back(BestOf(proposal.result.log_likelihoods, proposal.result.score));
    const TfIdfResult similar = tf_idf.Query({words, {}, {}});
    trial.tf_idf.push_back(BestOf(similar.similarities, similar.score));
    trial.verified.push_back(BestOf(
        verify_watch.Measure([&] { return recognizer.QueryImage(image.features, image.camera); }),
        numbers));
  }
  trial.words_ms = words_watch.MeanMs();
  trial.fabmap_ms = fabmap_watch.MeanMs();
  trial.verify_ms = verify_watch.MeanMs() - trial.words_ms - trial.fabmap_ms;
  trial.bytes_per_place = static_cast<double>(recognizer.index().NumBytes()) /
                          static_cast<double>(std::max<size_t>(1, database.size()));
  trial.counters = recognizer.counters();
  return trial;
}

}  // namespace rovio_sfm
