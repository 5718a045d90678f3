#include "rovio_sfm/tools/place_trial.h"

#include <algorithm>
#include <ctime>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "rovio_sfm/frontend/prepare_image.h"
#include "rovio_sfm/places/tf_idf.h"
#include "rovio_sfm/scene/memory_frame_store.h"
#include "rovio_sfm/tools/read_picture.h"
#include "rovio_sfm/util/executor.h"

namespace rovio_sfm {
namespace {

// None, named: the image cannot be read.
std::optional<PlaceImage> ExtractPlaceImage(const PlaceImages& images, uint32_t index,
                                            uint32_t folder, const FrontendOptions& options) {
  const DatasetImage& source = images.dataset.images[index];
  const DecodeResult decoded = ReadPicture(source.path, options.max_pixels);
  if (decoded.bgr.empty()) {
    TellLeftOut(decoded.reason);
    return std::nullopt;
  }
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

CandidateOptions OnlyTheBest() {
  CandidateOptions options;
  options.min_score = -std::numeric_limits<double>::infinity();
  options.max_candidates = 1;
  return options;
}

// The recognizers of a trial, filled and asked image by image.
class TrialRunner {
 public:
  TrialRunner(const std::vector<PlaceImage>& database,
              const std::shared_ptr<const PlaceModel>& model, const PlaceRecognizerOptions& options,
              const PlaceTrialOptions& trial_options)
      : database_(database),
        trial_options_(trial_options),
        recognizer_(options, model, &store_),
        tf_idf_(*model) {}

  void Remember(size_t number) {
    const PlaceImage& image = database_[number];
    numbers_[image.id] = number;
    of_place_.push_back(number);
    store_.Put(image.id, image.features);
    recognizer_.Remember(EventOf(image));
    tf_idf_.AddPlace(recognizer_.WordsOf(image.features));
  }

  void Ask(const PlaceImage& image) {
    const bool goes_on = trial_options_.use_prior && last_ && last_drive_ == image.id.drive;
    const FabmapResult* last = goes_on ? &*last_ : nullptr;
    const auto words = words_watch_.Measure([&] { return recognizer_.WordsOf(image.features); });
    PlaceProposal proposal = fabmap_watch_.Measure(
        [&] { return recognizer_.index().AskAll(words, OnlyTheBest(), last); });
    trial_.fabmap.push_back(BestOf(proposal.candidates));
    trial_.tf_idf.push_back(BestOf(tf_idf_.Query({words, {}, {}})));
    trial_.verified.push_back(BestOf(verify_watch_.Measure(
        [&] { return recognizer_.QueryImage(image.features, image.camera, last); })));
    if (trial_options_.keep_scores) KeepScores(proposal.result);
    last_ = std::move(proposal.result);
    last_drive_ = image.id.drive;
  }

  PlaceTrial Finish() {
    trial_.words_ms = words_watch_.MeanMs();
    trial_.fabmap_ms = fabmap_watch_.MeanMs();
    trial_.verify_ms = verify_watch_.MeanMs() - trial_.words_ms - trial_.fabmap_ms;
    trial_.bytes_per_place = static_cast<double>(recognizer_.index().NumBytes()) /
                             static_cast<double>(std::max<size_t>(1, of_place_.size()));
    trial_.counters = recognizer_.counters();
    return std::move(trial_);
  }

 private:
  std::optional<PlaceAnswer> BestOf(const std::vector<PlaceCandidate>& candidates) const {
    if (candidates.empty()) return std::nullopt;
    return PlaceAnswer{numbers_.at(candidates.front().id), candidates.front().score};
  }

  std::optional<PlaceAnswer> BestOf(const TfIdfResult& result) const {
    const std::vector<uint32_t> best = BestPlaces(result.similarities, 1);
    if (best.empty()) return std::nullopt;
    return PlaceAnswer{of_place_[best.front()], result.score};
  }

  // The match with most inliers.
  std::optional<PlaceAnswer> BestOf(const std::vector<PlaceMatch>& matches) const {
    std::optional<PlaceAnswer> best;
    for (const PlaceMatch& match : matches) {
      const OverlapPair& pair = match.pairs.front();
      const auto score = static_cast<double>(pair.inliers.size());
      if (!best || score > best->score) best = PlaceAnswer{numbers_.at(pair.other), score};
    }
    return best;
  }

  void KeepScores(const FabmapResult& result) {
    std::vector<double>& row =
        trial_.scores.emplace_back(database_.size(), -std::numeric_limits<double>::infinity());
    for (size_t place = 0; place < result.log_likelihoods.size(); ++place) {
      row[of_place_[place]] = result.log_likelihoods[place] - result.new_place_log_likelihood;
    }
  }

  const std::vector<PlaceImage>& database_;
  PlaceTrialOptions trial_options_;
  MemoryFrameStore store_;
  PlaceRecognizer recognizer_;
  TfIdf tf_idf_;
  std::map<FrameId, size_t> numbers_;  // in the database
  std::vector<size_t> of_place_;       // the same by place
  std::optional<FabmapResult> last_;   // of the query before
  DriveId last_drive_;
  Stopwatch words_watch_, fabmap_watch_, verify_watch_;
  PlaceTrial trial_;
};

// Those that were read; the others go out of `images` too.
std::vector<PlaceImage> KeepRead(std::vector<std::optional<PlaceImage>> found,
                                 PlaceImages* images) {
  std::vector<PlaceImage> kept;
  for (size_t i = 0; i < found.size(); ++i) {
    if (!found[i]) continue;
    images->indices[kept.size()] = images->indices[i];
    images->poses[kept.size()] = images->poses[i];
    kept.push_back(std::move(*found[i]));
  }
  if (kept.empty()) {
    throw std::runtime_error(images->dataset.path.string() + ": none of " +
                             std::to_string(found.size()) + " images can be read");
  }
  images->indices.resize(kept.size());
  images->poses.resize(kept.size());
  return kept;
}

}  // namespace

std::vector<PlaceImage> ExtractPlaceImages(PlaceImages* images, uint32_t folder,
                                           const FrontendOptions& options, int num_threads) {
  Executor executor(num_threads > 1 ? num_threads : 0);
  TaskGroup<std::optional<PlaceImage>> tasks(&executor);
  for (const uint32_t index : images->indices) {
    tasks.Add([images, index, folder, &options] {
      return ExtractPlaceImage(*images, index, folder, options);
    });
  }
  std::vector<std::optional<PlaceImage>> found;
  while (tasks.NumPending() > 0) found.push_back(tasks.TakeNext());
  return KeepRead(std::move(found), images);
}

bool KnowsImage(const std::vector<PlaceImage>& queries, size_t i, size_t j, size_t self_gap) {
  return j < i && (queries[j].id.drive != queries[i].id.drive || j + self_gap <= i);
}

PlaceTrial RunPlaceTrial(const std::vector<PlaceImage>& queries,
                         const std::vector<PlaceImage>& database,
                         const std::shared_ptr<const PlaceModel>& model,
                         const PlaceRecognizerOptions& options,
                         const PlaceTrialOptions& trial_options) {
  const bool is_self = trial_options.self_gap > 0;
  TrialRunner runner(database, model, options, trial_options);
  for (size_t i = is_self ? queries.size() : 0; i < database.size(); ++i) runner.Remember(i);
  size_t num_known = 0;
  for (size_t i = 0; i < queries.size(); ++i) {
    while (is_self && KnowsImage(queries, i, num_known, trial_options.self_gap)) {
      runner.Remember(num_known++);
    }
    runner.Ask(queries[i]);
  }
  return runner.Finish();
}

}  // namespace rovio_sfm
