#include "rovio_sfm/io/undistort_image.h"

#include <opencv2/calib3d.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "rovio_sfm/util/text_ends.h"

namespace rovio_sfm {
namespace {

constexpr int kJpegQuality = 95;

cv::Matx33d MatrixOf(const Camera& camera) {
  return {camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0};
}

cv::Mat DecodeImage(const std::vector<uint8_t>& encoded, const Camera& camera) {
  if (encoded.empty()) throw std::runtime_error("a picture has no bytes");
  cv::Mat image = cv::imdecode(encoded, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
  if (image.cols == camera.width && image.rows == camera.height) return image;
  throw std::runtime_error("a picture has " + std::to_string(image.cols) + " x " +
                           std::to_string(image.rows) + " px: expected " +
                           std::to_string(camera.width) + " x " + std::to_string(camera.height));
}

}  // namespace

Camera IdealCamera(const Camera& camera) {
  Camera ideal;
  ideal.fx = ideal.fy = camera.MeanFocal();
  ideal.cx = 0.5 * (camera.width - 1);
  ideal.cy = 0.5 * (camera.height - 1);
  ideal.width = camera.width;
  ideal.height = camera.height;
  return ideal;
}

std::vector<uint8_t> UndistortImage(const std::vector<uint8_t>& encoded, const Camera& camera) {
  const cv::Mat image = DecodeImage(encoded, camera);
  const cv::Vec<double, 5> distortion(camera.k1, camera.k2, camera.p1, camera.p2, camera.k3);
  cv::Mat undistorted;
  cv::undistort(image, undistorted, MatrixOf(camera), distortion, MatrixOf(IdealCamera(camera)));
  std::vector<uint8_t> bytes;
  if (!cv::imencode(".jpg", undistorted, bytes, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality})) {
    throw std::runtime_error("an undistorted picture cannot be encoded");
  }
  return bytes;
}

std::string UndistortedName(const std::string& name) {
  const bool is_jpeg = EndsWith(name, ".jpg") || EndsWith(name, ".jpeg") || EndsWith(name, ".JPG");
  return is_jpeg ? name : name + ".jpg";
}

}  // namespace rovio_sfm
