#include "rovio_sfm/dense/depth_view.h"

#include <opencv2/calib3d.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

namespace rovio_sfm {
namespace {

std::string SizeText(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

cv::Matx33d MatrixOf(const Camera& camera) {
  return {camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0};
}

}  // namespace

DepthView MakeDepthView(const std::vector<uint8_t>& encoded, const Camera& camera) {
  if (encoded.empty()) throw std::runtime_error("picture: no bytes");
  const cv::Mat picture = cv::imdecode(encoded, cv::IMREAD_COLOR);
  if (picture.cols != camera.width || picture.rows != camera.height) {
    throw std::runtime_error("picture: size = " + SizeText(picture.cols, picture.rows) +
                             ": expected " + SizeText(camera.width, camera.height));
  }
  const cv::Vec<double, 5> distortion(camera.k1, camera.k2, camera.p1, camera.p2, camera.k3);
  cv::Mat straight;
  cv::undistort(picture, straight, MatrixOf(camera), distortion);
  DepthView view;
  cv::resize(straight, view.bgr, {camera.width / 2, camera.height / 2}, 0, 0, cv::INTER_AREA);
  cv::cvtColor(view.bgr, view.grey, cv::COLOR_BGR2GRAY);
  // Pixel centres: x at half size is (x - 0.5) / 2.
  view.pixel_from_ray << camera.fx / 2, 0.0, (camera.cx - 0.5) / 2,  //
      0.0, camera.fy / 2, (camera.cy - 0.5) / 2,                     //
      0.0, 0.0, 1.0;
  return view;
}

}  // namespace rovio_sfm
