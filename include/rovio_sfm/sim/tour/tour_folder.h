#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/sim/tour/find_overlaps.h"
#include "rovio_sfm/sim/tour/simulate_tour.h"

namespace rovio_sfm::sim {

// Writes a data set's folder (data.md). Every function throws std::runtime_error that names the
// path it could not write.
class TourFolder {
 public:
  // Makes the folder and images/ in it; refuses a folder that holds times.txt unless overwrite.
  TourFolder(const std::string& path, bool overwrite);

  void WriteImage(size_t index, const std::vector<uint8_t>& jpeg) const;
  // times.txt, groundtruth.txt, odometry.txt, extrinsics.txt
  void WriteFrames(const SimulatedTour& tour) const;
  void WriteCalibration(const std::string& name, const Camera& camera) const;
  // name: overlaps.txt, or overlaps_<tour>.txt for pairs with another tour's pictures.
  void WriteOverlaps(const std::string& name, const std::vector<ViewOverlap>& overlaps) const;
  void WriteText(const std::string& name, const std::string& text) const;

 private:
  std::string path_;
};

}  // namespace rovio_sfm::sim
