#include "rovio_sfm/ros/bag_pictures.h"

namespace rovio_sfm {

// From where the last search ended, then once from the bag's start.
ImageBytes BagPictures::Find(size_t drive, int64_t stamp_ns) {
  if (drive != drive_) images_.reset();
  drive_ = drive;
  for (const bool again : {false, true}) {
    if (again || !images_) {
      images_ = std::make_unique<BagImages>(drives_[drive], options_, camera_);
    }
    while (const std::optional<ImageEvent> image = images_->Next()) {
      if (image->stamp_ns == stamp_ns) return image->encoded;
    }
  }
  return nullptr;
}

}  // namespace rovio_sfm
