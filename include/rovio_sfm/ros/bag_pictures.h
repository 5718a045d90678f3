#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "rovio_sfm/ros/bag_images.h"
#include "rovio_sfm/ros/image_bytes.h"

namespace rovio_sfm {

// The encoded pictures of drives that were mapped, found again in their bags. Asked in the order of
// the bags it reads each once; nothing is kept.
class BagPictures {
 public:
  // As for BagImages: the same stamps come again.
  BagPictures(std::vector<BagDrive> drives, SensorOptions options,
              std::optional<Camera> camera = std::nullopt)
      : drives_(std::move(drives)), options_(std::move(options)), camera_(std::move(camera)) {}

  // Of a drive's image with this stamp; null where its bag has none.
  ImageBytes Find(size_t drive, int64_t stamp_ns);

 private:
  std::vector<BagDrive> drives_;
  SensorOptions options_;
  std::optional<Camera> camera_;
  size_t drive_ = 0;                   // that is read, counted as given
  std::unique_ptr<BagImages> images_;  // of it, behind the last found; null: from its start
};

}  // namespace rovio_sfm
