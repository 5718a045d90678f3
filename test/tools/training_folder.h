#pragma once

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "features/test_images.h"
#include "rovio_sfm/tools/train_place_model.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {

// Writes small photographs into the folder; their paths, in order of name.
inline std::vector<std::filesystem::path> WriteTrainingImages(const TemporaryFolder& folder,
                                                              int count) {
  std::filesystem::create_directories(folder.Path() / "images");
  std::vector<std::filesystem::path> paths;
  for (int i = 0; i < count; ++i) {
    paths.push_back(folder.Path() / "images" / (std::to_string(i) + ".png"));
    cv::imwrite(paths.back().string(), TexturedImage(160, 120, static_cast<uint64_t>(i)));
  }
  return paths;
}

// Options that train in a moment.
inline TrainPlacesOptions QuickTraining() {
  TrainPlacesOptions options;
  options.frontend.extract.max_features = 60;
  options.cluster.num_words = 40;
  options.second_look.max_pairs = 3;
  return options;
}

}  // namespace rovio_sfm
