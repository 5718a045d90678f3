#pragma once

#include <filesystem>
#include <string>

#include "rovio_sfm/geometry/camera.h"

namespace rovio_sfm {

// Reads calibration.txt of a data-set folder: one line fx fy cx cy k1 k2 p1 p2 k3 width height
// (plumb-bob). Throws std::runtime_error naming file, line and field.
Camera ReadCalibrationText(const std::filesystem::path& path);

// The camera_info YAML that camera_info_manager reads and writes (plumb_bob). ReadCameraInfo throws
// std::runtime_error naming file and key.
Camera ReadCameraInfo(const std::filesystem::path& path);
// Either: YAML where the name ends in .yaml or .yml.
Camera ReadCamera(const std::filesystem::path& path);
std::string CameraInfoYaml(const Camera& camera, const std::string& camera_name);

}  // namespace rovio_sfm
