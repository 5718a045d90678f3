#pragma once

#include <vector>

#include "rovio_sfm/io/named_file.h"
#include "rovio_sfm/scene/map_model.h"

namespace rovio_sfm {

// A model of COLMAP: cameras, images and points3D as .txt or .bin. Cameras are PINHOLE, OPENCV or
// FULL_OPENCV, the simplest that holds them. In COLMAP the centre of the upper left pixel is (0.5,
// 0.5): half a pixel is added to principal points and features. Ids are indices + 1; the poses are
// cam_from_map, quaternions w x y z.
std::vector<NamedFile> ColmapTextFiles(const MapModel& model);
std::vector<NamedFile> ColmapBinaryFiles(const MapModel& model);

}  // namespace rovio_sfm
