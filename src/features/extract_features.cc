#include "rovio_sfm/features/extract_features.h"

#include <algorithm>
#include <cmath>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "rovio_sfm/features/root_sift.h"
#include "rovio_sfm/features/select_keypoints.h"
#include "rovio_sfm/features/sift_descriptors.h"
#include "rovio_sfm/features/sift_keypoints.h"
#include "rovio_sfm/features/sift_octaves.h"
#include "rovio_sfm/features/surf_features.h"
#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm {
namespace {

// Keypoints in pixels, with descriptors row by row.
struct Described {
  std::vector<cv::KeyPoint> keypoints;
  Descriptors descriptors;
};

SelectOptions SelectOptionsFrom(const ExtractOptions& options) {
  SelectOptions select;
  select.max_keypoints = options.max_features;
  select.max_candidates = static_cast<int>(options.candidate_factor * options.max_features);
  select.cell_px = options.cell_px;
  select.min_distance_px = options.min_distance_px;
  select.border_px = options.border_px;
  return select;
}

Described ExtractSift(const cv::Mat& grey, const ExtractOptions& options) {
  const std::vector<SiftOctave> octaves = BuildSiftOctaves(grey, options.upsample);
  SelectOptions select = SelectOptionsFrom(options);
  select.size_exponent = options.sift_size_exponent;
  Described described;
  described.keypoints = SelectKeypoints(
      FindSiftKeypoints(octaves, {options.sift_contrast, options.sift_edge}), grey.size(), select);
  if (options.fill_with_corners &&
      described.keypoints.size() < static_cast<size_t>(options.max_features)) {
    FillWith(FindCorners(octaves.front(), options.min_distance_px), grey.size(), select,
             &described.keypoints);
  }
  OrientSift(octaves, &described.keypoints);
  described.descriptors = RootSiftFromSift(DescribeSift(octaves, described.keypoints));
  return described;
}

// ORB and AKAZE: detect, choose, describe the chosen.
Described ExtractBinary(cv::Feature2D* detector, DescriptorType type, const cv::Mat& grey,
                        const ExtractOptions& options) {
  std::vector<cv::KeyPoint> candidates;
  detector->detect(grey, candidates);
  Described described{SelectKeypoints(candidates, grey.size(), SelectOptionsFrom(options)), {}};
  cv::Mat bits;
  if (!described.keypoints.empty()) detector->compute(grey, described.keypoints, bits);
  described.descriptors.type = type;
  described.descriptors.metric = DescriptorMetric::kHamming;
  described.descriptors.length = static_cast<uint32_t>(detector->descriptorSize());
  for (int row = 0; row < bits.rows; ++row) {
    described.descriptors.data.insert(described.descriptors.data.end(), bits.ptr(row),
                                      bits.ptr(row) + bits.cols);
  }
  return described;
}

Described Describe(const cv::Mat& grey, const ExtractOptions& options) {
  switch (options.type) {
    case DescriptorType::kSift:
      return ExtractSift(grey, options);
    case DescriptorType::kOrb:
      return ExtractBinary(
          cv::ORB::create(2 * SelectOptionsFrom(options).max_candidates, 1.2f, 8, 31, 0, 2,
                          cv::ORB::HARRIS_SCORE, 31, options.orb_threshold)
              .get(),
          DescriptorType::kOrb, grey, options);
    case DescriptorType::kAkaze:
      return ExtractBinary(cv::AKAZE::create(cv::AKAZE::DESCRIPTOR_MLDB, 0, 3,
                                             static_cast<float>(options.akaze_threshold))
                               .get(),
                           DescriptorType::kAkaze, grey, options);
    case DescriptorType::kSurf: {
      SurfFeatures surf = ExtractSurf(grey, options.surf_threshold, SelectOptionsFrom(options));
      return {std::move(surf.keypoints), std::move(surf.descriptors)};
    }
    case DescriptorType::kNone:
      break;
  }
  ROVIO_CHECK(false, "extract.type is none");
  return {};
}

Keypoint KeypointFrom(const cv::KeyPoint& keypoint, const Eigen::Vector2d& x_normalized) {
  Keypoint result;
  result.x_px = keypoint.pt.x;
  result.y_px = keypoint.pt.y;
  result.size_px = keypoint.size;
  result.angle_rad = static_cast<float>(Radians(keypoint.angle));
  result.response = keypoint.response;
  result.x_normalized = x_normalized;
  return result;
}

Rgb ColorAt(const cv::Mat& bgr, const cv::Point2f& point) {
  const int x = std::clamp(static_cast<int>(std::lround(point.x)), 0, bgr.cols - 1);
  const int y = std::clamp(static_cast<int>(std::lround(point.y)), 0, bgr.rows - 1);
  const auto& pixel = bgr.at<cv::Vec3b>(y, x);
  return {pixel[2], pixel[1], pixel[0]};
}

}  // namespace

FrameFeatures ExtractFeatures(const cv::Mat& bgr, const Camera& camera,
                              const ExtractOptions& options) {
  ROVIO_CHECK(bgr.type() == CV_8UC3);
  cv::Mat grey;
  cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
  const Described described = Describe(grey, options);
  FrameFeatures features;
  features.descriptors = described.descriptors;
  features.descriptors.data.clear();
  for (size_t i = 0; i < described.keypoints.size(); ++i) {
    const cv::KeyPoint& keypoint = described.keypoints[i];
    const auto x_normalized = NormalizedFromPixel(camera, {keypoint.pt.x, keypoint.pt.y});
    if (!x_normalized) continue;
    features.keypoints.push_back(KeypointFrom(keypoint, *x_normalized));
    features.colors.push_back(ColorAt(bgr, keypoint.pt));
    const uint8_t* row = described.descriptors.Row(i);
    features.descriptors.data.insert(features.descriptors.data.end(), row,
                                     row + described.descriptors.length);
  }
  return features;
}

}  // namespace rovio_sfm
