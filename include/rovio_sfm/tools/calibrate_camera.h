#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

struct CalibrateCameraOptions {
  int columns = 9, rows = 6;
  int min_boards = 5;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("columns", columns, 3, 50, "inner corners of the chessboard");
    table.AddNumber("rows", rows, 3, 50, "inner corners of the chessboard");
    table.AddNumber("min_boards", min_boards, 3, 1000, "fewer are refused");
  }
};

struct CalibrationReport {
  Camera camera;
  double rms_px = 0.0;                               // reprojection error of the corners
  std::vector<std::filesystem::path> without_board;  // images in which no board was found
};

// Calibrates from images of a chessboard by Zhang's method (§3.2), plumb-bob distortion.
// Unreadable images are left out and named on the log. Throws std::runtime_error for mixed sizes or
// too few boards.
CalibrationReport CalibrateCamera(const std::vector<std::filesystem::path>& images,
                                  const CalibrateCameraOptions& options);

// The command calibrate_camera: images in, camera_info YAML out. Returns the exit status.
int CalibrateCameraCommand(int argc, const char* const* argv, std::ostream& out);

}  // namespace rovio_sfm
