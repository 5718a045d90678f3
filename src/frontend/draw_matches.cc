#include "rovio_sfm/frontend/draw_matches.h"

#include <opencv2/imgproc.hpp>
#include <string>
#include <unordered_set>

#include "rovio_sfm/matching/filter_matches.h"

namespace rovio_sfm {
namespace {

const cv::Scalar kRed(60, 60, 230), kYellow(40, 200, 240), kGreen(80, 220, 80);
const cv::Scalar kGrey(170, 170, 170), kWhite(255, 255, 255), kBlack(0, 0, 0);

cv::Point2f PointOf(const Keypoint& keypoint) { return {keypoint.x_px, keypoint.y_px}; }

void DrawText(const std::string& text, cv::Mat* image) {
  const cv::Point origin(6, image->rows - 8);
  cv::putText(*image, text, origin, cv::FONT_HERSHEY_SIMPLEX, 0.45, kBlack, 3, cv::LINE_AA);
  cv::putText(*image, text, origin, cv::FONT_HERSHEY_SIMPLEX, 0.45, kWhite, 1, cv::LINE_AA);
}

std::string CountsText(const PairMatches& pair) {
  const MatchCounts& counts = pair.counts;
  return "features " + std::to_string(counts.features) + "  ratio " + std::to_string(counts.ratio) +
         "  percentile " + std::to_string(counts.percentile) + "  one-to-one " +
         std::to_string(counts.one_to_one) + "  RANSAC " + std::to_string(counts.ransac) +
         "  guided " + std::to_string(counts.guided);
}

cv::Mat SideBySide(const cv::Mat& left, const cv::Mat& right) {
  cv::Mat image(std::max(left.rows, right.rows), left.cols + right.cols, CV_8UC3, kBlack);
  left.copyTo(image(cv::Rect(cv::Point(0, 0), left.size())));
  right.copyTo(image(cv::Rect(cv::Point(left.cols, 0), right.size())));
  return image;
}

}  // namespace

cv::Mat DrawKeypoints(const cv::Mat& bgr, const FrameEvent& event) {
  std::unordered_set<uint32_t> matched;
  for (const PairMatches& pair : event.pairs) {
    for (const FeatureMatch& match : pair.inliers) matched.insert(match.b);
  }
  cv::Mat image = bgr.clone();
  const bool is_light = event.kind == FrameKind::kLight;
  for (uint32_t i = 0; i < event.features->keypoints.size(); ++i) {
    const bool stands_out = is_light || matched.count(i) > 0;
    cv::circle(image, PointOf(event.features->keypoints[i]), 2, stands_out ? kGreen : kGrey, 1,
               cv::LINE_AA);
  }
  DrawText(event.image_name + (is_light ? "  light" : "  keyframe"), &image);
  return image;
}

cv::Mat DrawMatches(const cv::Mat& other_bgr, const FrameFeatures& other, const cv::Mat& bgr,
                    const FrameFeatures& features, const PairMatches& pair,
                    const PairOptions& options) {
  const auto by_ratio = FilterByRatio(
      MatchDescriptors(other.descriptors, features.descriptors, options.match), options.max_ratio);
  const auto one_to_one = FilterOneToOne(FilterByMeanDistance(by_ratio, options.max_mean_factor));
  cv::Mat image = SideBySide(other_bgr, bgr);
  const cv::Point2f shift(static_cast<float>(other_bgr.cols), 0.0f);
  const auto draw = [&](const std::vector<FeatureMatch>& matches, const cv::Scalar& color) {
    for (const FeatureMatch& match : matches) {
      cv::line(image, PointOf(other.keypoints[match.a]),
               PointOf(features.keypoints[match.b]) + shift, color, 1, cv::LINE_AA);
    }
  };
  draw(by_ratio, kRed);
  draw(one_to_one, kYellow);
  draw(pair.inliers, kGreen);
  DrawText(CountsText(pair), &image);
  return image;
}

}  // namespace rovio_sfm
