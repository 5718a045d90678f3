#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rovio_sfm/frontend/frontend_options.h"
#include "rovio_sfm/places/cluster_words.h"
#include "rovio_sfm/places/measure_detector.h"
#include "rovio_sfm/places/place_model.h"
#include "rovio_sfm/tools/second_look.h"
#include "rovio_sfm/tools/training_checkpoint.h"
#include "rovio_sfm/tools/training_images.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

struct TrainPlacesOptions {
  FrontendOptions frontend;
  ClusterOptions cluster;
  int max_cluster_features = 250'000;
  ChowLiuOptions tree;
  SecondLookOptions second_look;
  double p_z_given_e = 0.03;  // of the detector; 0: what second looks say
  uint64_t seed = 1;

  void DescribeOptions(OptionTable& table) {
    table.AddGroup("frontend", frontend, "images are denoised and features found as live");
    table.AddRule("frontend.extract.type", frontend.extract.type == DescriptorType::kSift, "sift");
    table.AddGroup("cluster", cluster, "");
    table.AddNumber("max_cluster_features", max_cluster_features, 100, 1e7, "thinned evenly");
    table.AddGroup("tree", tree, "");
    table.AddGroup("second_look", second_look, "");
    table.AddNumber("p_z_given_e", p_z_given_e, 0.0, 0.99, "of the detector; 0: measured");
    table.AddNumber("seed", seed, 0, kNoLimit, "of the first words and of the second looks");
  }
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
