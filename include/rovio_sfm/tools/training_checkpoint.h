#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "rovio_sfm/places/cluster_words.h"
#include "rovio_sfm/tools/training_images.h"

namespace rovio_sfm {

// What an interrupted training has reached, kept in a folder. A key says from what something was
// made: what was made from something else is not taken up. Files that are broken are not taken up
// either. Throws std::runtime_error only where it cannot write.
class TrainingCheckpoint {
 public:
  // Makes the folder if it is not there.
  explicit TrainingCheckpoint(const std::filesystem::path& folder);

  std::optional<TrainingFeatures> LoadFeatures(const std::string& key) const;
  void SaveFeatures(const std::string& key, const TrainingFeatures& features) const;
  std::optional<ClusterState> LoadWords(const std::string& key) const;
  void SaveWords(const std::string& key, const ClusterState& state) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace rovio_sfm
