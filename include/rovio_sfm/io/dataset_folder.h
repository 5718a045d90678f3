#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/io/trajectory_file.h"
#include "rovio_sfm/scene/frame.h"

namespace rovio_sfm {

struct DatasetImage {
  std::filesystem::path path;
  std::string name;  // as in times.txt
  int64_t stamp_ns = 0;
  std::optional<OdometrySample> odometry;  // interpolated at the stamp
  std::optional<Rigid3> base_from_camera;  // interpolated at the stamp; metres
};

// Two images that show the same place (overlaps.txt).
struct DatasetOverlap {
  uint32_t image_a = 0, image_b = 0;  // index into images
  double covisible_share = 0.0;       // of the pixels, 0 … 1
  double angle_deg = 0.0;             // between the views
};

// A folder of images: images/, times.txt, calibration.txt and, optionally, groundtruth.txt,
// odometry.txt, extrinsics.txt and overlaps.txt.
struct DatasetFolder {
  std::filesystem::path path;
  Camera camera;
  std::vector<DatasetImage> images;       // by rising stamp
  std::vector<StampedPose> ground_truth;  // world_from_camera; empty where there is none
  std::vector<DatasetOverlap> overlaps;
};

// Reads the folder (not the images themselves). Throws std::runtime_error that names file, line and
// field; an optional file that is there but malformed is an error too. Images whose stamp repeats
// or falls by at most a second are left out, and the log tells how many.
DatasetFolder ReadDatasetFolder(const std::filesystem::path& path);

// Every stride-th image of the data set, the first included, and the overlaps among them; stride >
// 0.
DatasetFolder EveryNth(const DatasetFolder& dataset, size_t stride);

}  // namespace rovio_sfm
