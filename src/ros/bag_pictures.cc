#include "rovio_sfm/ros/bag_pictures.h"

namespace rovio_sfm {

// Round all drives once, from where the last search ended and back there.
ImageBytes BagPictures::Find(const std::string& robot, int64_t stamp_ns) {
  for (size_t tried = 0; tried <= drives_.size(); ++tried) {
    if (drives_[drive_].robot == robot) {
      if (!images_) images_ = std::make_unique<BagImages>(drives_[drive_], options_, camera_);
      while (const std::optional<ImageEvent> image = images_->Next()) {
        if (image->stamp_ns == stamp_ns) return image->encoded;
      }
    }
    images_.reset();
    drive_ = (drive_ + 1) % drives_.size();
  }
  return nullptr;
}

}  // namespace rovio_sfm
