#include "rovio_sfm/tools/train_place_model.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace rovio_sfm {
namespace {

// What the features depend on.
std::string FeaturesKey(const std::vector<std::filesystem::path>& images,
                        const TrainPlacesOptions& options) {
  const ExtractOptions& extract = options.frontend.extract;
  const DenoiseOptions& denoise = options.frontend.denoise;
  const SecondLookOptions& look = options.second_look;
  std::ostringstream key;
  key << "features 1, " << NameOfDescriptorType(extract.type) << ' ' << extract.max_features << ' '
      << extract.candidate_factor << ' ' << extract.sift_contrast << ' ' << extract.sift_edge << ' '
      << extract.upsample << ' ' << extract.cell_px << ' ' << extract.min_distance_px << ' '
      << extract.border_px << ", denoise " << denoise.enabled << ' ' << denoise.diameter_px << ' '
      << denoise.sigma_color << ' ' << denoise.sigma_space_px << ", looks " << look.max_roll_deg
      << ' ' << look.max_zoom << ' ' << look.max_shift << ' ' << look.max_perspective << ' '
      << look.max_gain << ' ' << look.noise_sigma << ' ' << look.max_pairs << ' ' << options.seed;
  for (const std::filesystem::path& image : images) {
    key << '\n' << image.filename().string() << ' ' << std::filesystem::file_size(image);
  }
  return key.str();
}

std::string WordsKey(const std::string& features_key, const TrainPlacesOptions& options) {
  std::ostringstream key;
  key << "words 1, " << options.cluster.num_words << ' ' << options.max_cluster_features << ' '
      << options.seed << '\n'
      << features_key;
  return key.str();
}

TrainingFeatures FindTrainingFeatures(const std::vector<std::filesystem::path>& images,
                                      const TrainPlacesOptions& options, const std::string& key,
                                      const TrainingCheckpoint& checkpoint, bool resume,
                                      Executor* executor, const TrainingProgress& progress) {
  if (resume) {
    if (auto features = checkpoint.LoadFeatures(key)) return std::move(*features);
  }
  TrainingFeatures features = ExtractTrainingFeatures(images, options.frontend, options.second_look,
                                                      options.seed, executor, progress);
  checkpoint.SaveFeatures(key, features);
  return features;
}

ClusterState FindWords(const Descriptors& features, const TrainPlacesOptions& options,
                       const std::string& key, const TrainingCheckpoint& checkpoint, bool resume,
                       Executor* executor, const TrainingProgress& progress) {
  const auto total = static_cast<size_t>(options.cluster.max_iterations);
  progress("words", 0, total);
  std::optional<ClusterState> reached;
  if (resume) reached = checkpoint.LoadWords(key);
  Rng rng(options.seed);
  return ClusterWords(features, options.cluster, std::move(reached), &rng, executor,
                      [&](const ClusterState& state) {
                        checkpoint.SaveWords(key, state);
                        progress("words", state.converged ? total : state.num_iterations, total);
                      });
}

std::vector<WordBag> QuantizeAll(const std::vector<Descriptors>& images,
                                 const Vocabulary& vocabulary, Executor* executor) {
  TaskGroup<WordBag> tasks(executor);
  for (const Descriptors& image : images) {
    tasks.Add([&image, &vocabulary] { return BagOfWords(vocabulary.Quantize(image)); });
  }
  std::vector<WordBag> bags;
  while (tasks.NumPending() > 0) bags.push_back(tasks.TakeNext());
  return bags;
}

std::vector<BagPair> PairsOfLooks(const TrainingFeatures& features,
                                  const std::vector<WordBag>& bags, const Vocabulary& vocabulary,
                                  Executor* executor) {
  const std::vector<WordBag> second = QuantizeAll(features.second_looks, vocabulary, executor);
  std::vector<BagPair> pairs;
  for (size_t i = 0; i < second.size(); ++i) {
    pairs.push_back({bags[features.looked_at[i]], second[i]});
  }
  return pairs;
}

std::string ProvenanceOf(size_t num_images, const TrainPlacesOptions& options) {
  std::ostringstream text;
  text << "train_places: " << num_images << " images, " << options.cluster.num_words << " words, "
       << options.frontend.extract.max_features << " features an image, seed " << options.seed;
  return text.str();
}

}  // namespace

TrainingResult TrainPlaces(const std::vector<std::filesystem::path>& images,
                           const TrainPlacesOptions& options, const TrainingCheckpoint& checkpoint,
                           bool resume, Executor* executor, const TrainingProgress& progress) {
  const std::string key = FeaturesKey(images, options);
  const TrainingFeatures features =
      FindTrainingFeatures(images, options, key, checkpoint, resume, executor, progress);
  const Descriptors thinned =
      ThinFeatures(features.images, static_cast<size_t>(options.max_cluster_features));
  if (thinned.Count() == 0) throw std::runtime_error("train_places: the images show no features");
  const ClusterState words =
      FindWords(thinned, options, WordsKey(key, options), checkpoint, resume, executor, progress);
  TrainingResult result;
  result.num_iterations = words.num_iterations;
  result.rms_distance = std::sqrt(words.mean_squared_distance);
  PlaceModel& model = result.model;
  model.vocabulary = Vocabulary(words.words);
  progress("tree", 0, 1);
  model.training_bags = QuantizeAll(features.images, model.vocabulary, executor);
  model.tree = LearnChowLiuTree(model.training_bags, model.vocabulary.NumWords(), options.tree);
  progress("tree", 1, 1);
  result.detector = MeasureDetector(
      PairsOfLooks(features, model.training_bags, model.vocabulary, executor), model.tree);
  const double p_z_given_e =
      options.p_z_given_e > 0.0 ? options.p_z_given_e : result.detector.p_z_given_e;
  model.detector.p_z_given_e = std::clamp(p_z_given_e, 0.01, 0.99);
  model.provenance = ProvenanceOf(features.images.size(), options);
  return result;
}

}  // namespace rovio_sfm
