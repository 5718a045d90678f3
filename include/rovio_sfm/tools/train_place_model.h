#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/frontend/frontend_options.h"
#include "rovio_sfm/places/cluster_words.h"
#include "rovio_sfm/places/measure_detector.h"
#include "rovio_sfm/places/place_model.h"
#include "rovio_sfm/tools/second_look.h"
#include "rovio_sfm/tools/training_checkpoint.h"
#include "rovio_sfm/tools/training_images.h"

namespace rovio_sfm {

struct TrainPlacesOptions {
  FrontendOptions frontend;  // how images are denoised and features found: as live ones
  ClusterOptions cluster;
  int max_cluster_features = 250'000;  // clustered, evenly thinned from all; 100 to 1e7
  ChowLiuOptions tree;
  SecondLookOptions second_look;
  std::optional<double> p_z_given_e;  // instead of what second looks say; 0.01 to 0.99
  uint64_t seed = 1;                  // of the first words and of the second looks

  bool IsValid(std::string* error) const;
};

// A trained model and how it came about.
struct TrainingResult {
  PlaceModel model;
  DetectorReport detector;  // measured, whether used or not
  uint32_t num_iterations = 0;
  double rms_distance = 0.0;  // from features to their words, in units of the descriptors' bytes
};

// Learns all that FAB-MAP needs from photographs (§4.2.2): features, words by k-means, the Chow-Liu
// tree over the words of the images, the detector from second looks. Takes up from the checkpoint
// what was made from the same images and options (`resume`), and keeps there what it reaches.
// The threads change nothing. Throws std::runtime_error for images that cannot be used.
TrainingResult TrainPlaces(const std::vector<std::filesystem::path>& images,
                           const TrainPlacesOptions& options, const TrainingCheckpoint& checkpoint,
                           bool resume, Executor* executor, const TrainingProgress& progress);

}  // namespace rovio_sfm
