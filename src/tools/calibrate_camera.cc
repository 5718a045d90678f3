#include "rovio_sfm/tools/calibrate_camera.h"

#include <CLI/CLI.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <ostream>
#include <stdexcept>

#include "rovio_sfm/io/calibration.h"
#include "rovio_sfm/io/write_file.h"
#include "rovio_sfm/tools/list_images.h"
#include "rovio_sfm/tools/read_picture.h"
#include "rovio_sfm/util/check_options.h"
#include "rovio_sfm/util/parse_arguments.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kMaxPixels = 32'000'000;
constexpr int kSubPixelWindow = 5;  // px, half size
const cv::TermCriteria kSubPixelEnd(cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 50, 1e-3);

// Empty, and told on the log, where it cannot be read.
cv::Mat ReadGrey(const std::filesystem::path& path) {
  const DecodeResult decoded = ReadPicture(path, kMaxPixels);
  cv::Mat grey;
  if (decoded.bgr.empty()) {
    TellLeftOut(decoded.reason);
    return grey;
  }
  cv::cvtColor(decoded.bgr, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

std::optional<std::vector<cv::Point2f>> FindBoard(const cv::Mat& grey, cv::Size board) {
  std::vector<cv::Point2f> corners;
  if (!cv::findChessboardCorners(grey, board, corners)) return std::nullopt;
  cv::cornerSubPix(grey, corners, {kSubPixelWindow, kSubPixelWindow}, {-1, -1}, kSubPixelEnd);
  return corners;
}

// One square is the unit of length.
std::vector<cv::Point3f> BoardCorners(cv::Size board) {
  std::vector<cv::Point3f> corners;
  for (int row = 0; row < board.height; ++row) {
    for (int column = 0; column < board.width; ++column) {
      corners.emplace_back(static_cast<float>(column), static_cast<float>(row), 0.0f);
    }
  }
  return corners;
}

Camera CameraFromOpenCv(const cv::Mat& matrix, const cv::Mat& distortion, cv::Size size) {
  Camera camera;
  camera.fx = matrix.at<double>(0, 0), camera.fy = matrix.at<double>(1, 1);
  camera.cx = matrix.at<double>(0, 2), camera.cy = matrix.at<double>(1, 2);
  camera.k1 = distortion.at<double>(0), camera.k2 = distortion.at<double>(1);
  camera.p1 = distortion.at<double>(2), camera.p2 = distortion.at<double>(3);
  camera.k3 = distortion.at<double>(4);
  camera.width = size.width, camera.height = size.height;
  return camera;
}

void Report(const CalibrationReport& report, std::ostream& out) {
  for (const auto& path : report.without_board) out << "no board found: " << path.string() << "\n";
  const Camera& c = report.camera;
  out << "rms " << report.rms_px << " px, fx " << c.fx << " fy " << c.fy << " cx " << c.cx << " cy "
      << c.cy << ", distortion " << c.k1 << " " << c.k2 << " " << c.p1 << " " << c.p2 << " " << c.k3
      << "\n";
}

}  // namespace

CalibrationReport CalibrateCamera(const std::vector<std::filesystem::path>& images,
                                  const CalibrateCameraOptions& options) {
  const cv::Size board(options.columns, options.rows);
  CalibrationReport report;
  cv::Size size;
  std::vector<std::vector<cv::Point2f>> corners_px;
  for (const std::filesystem::path& path : images) {
    const cv::Mat grey = ReadGrey(path);
    if (grey.empty()) continue;
    if (size.area() > 0 && grey.size() != size)
      throw std::runtime_error(path.string() + ": other size");
    size = grey.size();
    if (const auto corners = FindBoard(grey, board)) {
      corners_px.push_back(*corners);
    } else {
      report.without_board.push_back(path);
    }
  }
  if (corners_px.size() < static_cast<size_t>(options.min_boards)) {
    throw std::runtime_error("found the chessboard in " + std::to_string(corners_px.size()) +
                             " images, need " + std::to_string(options.min_boards));
  }
  const std::vector<std::vector<cv::Point3f>> corners(corners_px.size(), BoardCorners(board));
  cv::Mat matrix, distortion;
  std::vector<cv::Mat> rotations, translations;
  report.rms_px =
      cv::calibrateCamera(corners, corners_px, size, matrix, distortion, rotations, translations);
  report.camera = CameraFromOpenCv(matrix, distortion, size);
  return report;
}

int CalibrateCameraCommand(int argc, const char* const* argv, std::ostream& out) {
  CLI::App app("Calibrates a camera from pictures of a chessboard, for camera_info_manager");
  CalibrateCameraOptions options;
  std::vector<std::string> arguments;
  std::string file, name = "camera";
  bool overwrite = false;
  app.add_option("images", arguments, "images, or folders of images")->required();
  app.add_option("--columns", options.columns, "inner corners along a row");
  app.add_option("--rows", options.rows, "rows of inner corners");
  app.add_option("--min-boards", options.min_boards, "fewest images with the whole board");
  app.add_option("--out", file, "camera_info YAML to write")->required();
  app.add_option("--name", name, "camera_name in the YAML");
  app.add_flag("--overwrite", overwrite, "replace the file");
  if (const auto status = ParseArguments(&app, argc, argv, out)) return *status;
  std::string error;
  if (!IsValid(options, &error)) throw std::runtime_error(error);
  const CalibrationReport report = CalibrateCamera(ListImages(arguments), options);
  Report(report, out);
  WriteFile(file, CameraInfoYaml(report.camera, name),
            overwrite ? Overwrite::kAllow : Overwrite::kRefuse);
  out << "wrote " << std::filesystem::absolute(file).string() << "\n";
  return 0;
}

}  // namespace rovio_sfm
