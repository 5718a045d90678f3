#include "rovio_sfm/finish/densify_map.h"

#include <functional>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "rovio_sfm/finish/join_tracks.h"
#include "rovio_sfm/finish/landmark_cloud.h"

namespace rovio_sfm {
namespace {

using FeaturesByImage = std::vector<FrameFeatures>;

constexpr size_t kMaxPending = 16;  // tasks that hold what they have read

// What one image's features are gathered from.
struct Ingredients {
  std::shared_ptr<const FrameFeatures> stored;
  std::shared_ptr<const std::vector<uint8_t>> picture;
};

Ingredients Read(const ModelImage& image, const ReadFeatures& features,
                 const ReadPicture& pictures) {
  Ingredients read;
  read.stored = features ? features(image) : nullptr;
  const bool is_whole = read.stored != nullptr &&
                        read.stored->keypoints.size() == image.keypoints.size() &&
                        read.stored->descriptors.Count() == image.keypoints.size();
  if (!is_whole) return {};
  read.picture = pictures ? pictures(image) : nullptr;
  return read;
}

// Without descriptors an image takes part with what its points see, and is matched with none.
FrameFeatures Gather(const ModelImage& image, const Camera& camera, const Ingredients& read,
                     const GatherOptions& options) {
  if (read.stored == nullptr) return {image.keypoints, {}, {}};
  try {
    return GatherFeatures(*read.stored, read.picture.get(), camera, options);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("frame " + image.id.ToString() + ": " + error.what());
  }
}

// Runs a task for every image; results by image. Empty where the progress ended it.
template <typename Result, typename Prepare, typename Task>
std::optional<std::vector<Result>> ForAllImages(size_t num_images, const Prepare& prepare,
                                                const Task& task, Executor* executor,
                                                const std::function<bool()>& goes_on) {
  std::vector<Result> results;
  TaskGroup<Result> tasks(executor);
  for (size_t i = 0; i < num_images || tasks.NumPending() > 0; ++i) {
    if (i < num_images) tasks.Add([&task, i, input = prepare(i)] { return task(i, input); });
    while (tasks.NumPending() > 0 && (i >= num_images || tasks.NumPending() >= kMaxPending)) {
      results.push_back(tasks.TakeNext());
      if (!goes_on()) return std::nullopt;
    }
  }
  return results;
}

class Densifier {
 public:
  Densifier(const MapModel& model, const DensifyOptions& options, Executor* executor,
            const DenseProgress& progress)
      : model_(model), options_(options), executor_(executor), progress_(progress) {}

  bool GatherAll(const ReadFeatures& features, const ReadPicture& pictures) {
    size_t num_whole = 0;
    const auto read = [&](size_t i) {
      Ingredients ingredients = Read(model_.images[i], features, pictures);
      num_whole += ingredients.stored == nullptr ? 0 : 1;
      return ingredients;
    };
    const auto gather = [this](size_t i, const Ingredients& ingredients) {
      const ModelImage& image = model_.images[i];
      return Gather(image, model_.cameras[image.camera], ingredients, options_.gather);
    };
    auto gathered = ForAllImages<FrameFeatures>(model_.images.size(), read, gather, executor_,
                                                [this] { return GoesOn(); });
    if (!gathered) return false;
    if (num_whole == 0 && !model_.images.empty()) {
      throw std::runtime_error("densify: no descriptors of the map's " +
                               std::to_string(model_.images.size()) + " keyframes are kept");
    }
    features_ = std::move(*gathered);
    for (size_t i = 0; i < features_.size(); ++i) {
      model_.images[i].keypoints = features_[i].keypoints;
      counts_.num_features += features_[i].keypoints.size();
    }
    return true;
  }

  bool MatchAll() {
    const auto pairs = ChoosePairs(model_, options_.pairs);
    const auto none = [](size_t) { return 0; };
    const SoundDepths sound(model_, model_.points.size(), options_.depth);
    const auto match = [&](size_t i, int) { return MatchImage(i, pairs[i], sound); };
    auto matched = ForAllImages<std::vector<PairMatches>>(model_.images.size(), none, match,
                                                          executor_, [this] { return GoesOn(); });
    if (!matched) return false;
    matches_ = std::move(*matched);
    for (const auto& of_image : matches_) {
      for (const PairMatches& pair : of_image) counts_.num_matches += pair.inliers.size();
    }
    return true;
  }

  DensifiedMap MakePoints() {
    counts_.before = MeasurePoints(model_);
    const size_t num_before = model_.points.size();
    const JoinedTracks joined = JoinTracks(model_, matches_, options_.same_feature_px);
    counts_.num_refused_f1 = joined.num_refused_f1;
    counts_.num_barren_tracks = AddPoints(joined.tracks, options_.grow, &model_);
    counts_.num_removed_points = AdjustPoints(num_before, options_.grow, &model_);
    counts_.num_inconsistent_depths = RemoveInconsistentDepths(num_before, options_.depth, &model_);
    counts_.after = MeasurePoints(model_);
    ColorAdded(num_before);
    return {LandmarkCloud(model_), counts_};
  }

 private:
  bool GoesOn() { return !progress_ || progress_(++num_done_, 2 * model_.images.size()); }

  std::vector<PairMatches> MatchImage(size_t b, const std::vector<uint32_t>& earlier,
                                      const SoundDepths& sound) const {
    std::vector<PairMatches> matches;
    const ModelImage& image = model_.images[b];
    std::vector<DepthRange> ranges;
    for (const Keypoint& keypoint : image.keypoints) {
      ranges.push_back(sound.Around(static_cast<uint32_t>(b), keypoint.x_normalized));
    }
    for (const uint32_t a : earlier) {
      const Rigid3 b_from_a = image.cam_from_map * Inverse(model_.images[a].cam_from_map);
      matches.push_back(MatchPosed(a, features_[a], features_[b], b_from_a, ranges,
                                   model_.cameras[image.camera].MeanFocal(), options_.match));
    }
    return matches;
  }

  void ColorAdded(size_t num_before) {
    for (size_t i = num_before; i < model_.points.size(); ++i) {
      const ModelView& first = model_.points[i].views.front();
      model_.points[i].color = features_[first.image].colors[first.keypoint];
    }
  }

  MapModel model_;
  const DensifyOptions& options_;
  Executor* executor_;
  const DenseProgress& progress_;
  size_t num_done_ = 0;
  FeaturesByImage features_;
  std::vector<std::vector<PairMatches>> matches_;  // by image
  DensifyCounts counts_;
};

}  // namespace

std::optional<DensifiedMap> DensifyMap(const MapModel& model, const ReadFeatures& features,
                                       const ReadPicture& pictures, const DensifyOptions& options,
                                       Executor* executor, const DenseProgress& progress) {
  Densifier densifier(model, options, executor, progress);
  if (!densifier.GatherAll(features, pictures) || !densifier.MatchAll()) return std::nullopt;
  return densifier.MakePoints();
}

std::vector<std::pair<std::string, std::string>> RowsOf(const DensifyCounts& counts) {
  const auto row = [](auto before, auto after) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(2) << before << " → " << after;
    return text.str();
  };
  const PointFigures &before = counts.before, &after = counts.after;
  return {{"densified points", row(before.num_points, after.num_points)},
          {"densified projections", row(before.num_projections, after.num_projections)},
          {"densified RMS_N", row(before.rms_n, after.rms_n)}};
}

std::string Describe(const DensifyCounts& counts) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << "densified: " << counts.before.num_points << " -> "
       << counts.after.num_points << " points, " << counts.before.num_projections << " -> "
       << counts.after.num_projections << " projections, RMS_N " << counts.before.rms_n << " -> "
       << counts.after.rms_n;
  return text.str();
}

}  // namespace rovio_sfm
