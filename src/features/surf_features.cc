#include "rovio_sfm/features/surf_features.h"

#include <dlib/image_keypoint.h>
#include <dlib/opencv.h>

#include <algorithm>
#include <cmath>

#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm {
namespace {

// A SURF feature of scale s covers 20 s pixels; its blob is about 2.5 s wide on either side.
constexpr double kSizeOfScale = 5.0;

// dlib reads without a check up to 16 scales around a point that it describes.
bool CanDescribe(const dlib::integral_image& integral, const dlib::interest_point& point) {
  const auto side = static_cast<unsigned long>(32.0 * point.scale);
  return dlib::get_rect(integral).contains(dlib::centered_rect(point.center, side, side));
}

std::vector<cv::KeyPoint> DetectSurf(const dlib::integral_image& integral, double threshold) {
  dlib::hessian_pyramid pyramid;
  pyramid.build_pyramid(integral, 4, 6, 2);
  std::vector<dlib::interest_point> points;
  dlib::get_interest_points(pyramid, threshold, points);
  std::vector<cv::KeyPoint> keypoints;
  for (const dlib::interest_point& p : points) {
    if (!CanDescribe(integral, p)) continue;
    keypoints.emplace_back(static_cast<float>(p.center.x()), static_cast<float>(p.center.y()),
                           static_cast<float>(p.scale * kSizeOfScale), 0.0f,
                           static_cast<float>(p.score));
  }
  return keypoints;
}

// Describes the keypoint and sets its angle (degrees, as OpenCV's).
void DescribeSurf(const dlib::integral_image& integral, cv::KeyPoint* keypoint,
                  std::vector<uint8_t>* data) {
  const dlib::vector<double, 2> center(keypoint->pt.x, keypoint->pt.y);
  const double scale = keypoint->size / kSizeOfScale;
  const double angle_rad = dlib::compute_dominant_angle(integral, center, scale);
  dlib::matrix<double, 64, 1> values;
  dlib::compute_surf_descriptor(integral, center, scale, angle_rad, values);
  keypoint->angle = static_cast<float>(std::fmod(Degrees(angle_rad) + 360.0, 360.0));
  for (const double value : values) {
    data->push_back(
        static_cast<uint8_t>(std::clamp(std::round(128.0 + 256.0 * value), 0.0, 255.0)));
  }
}

}  // namespace

SurfFeatures ExtractSurf(const cv::Mat& grey, double threshold, const SelectOptions& select) {
  dlib::integral_image integral;
  integral.load(dlib::cv_image<unsigned char>(grey));
  SurfFeatures features;
  features.keypoints = SelectKeypoints(DetectSurf(integral, threshold), grey.size(), select);
  features.descriptors.type = DescriptorType::kSurf;
  features.descriptors.length = 64;
  for (cv::KeyPoint& keypoint : features.keypoints) {
    DescribeSurf(integral, &keypoint, &features.descriptors.data);
  }
  return features;
}

}  // namespace rovio_sfm
