#include "rovio_sfm/features/flow.h"

#include <opencv2/video/tracking.hpp>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

constexpr int kMaxIterations = 30;       // per level
constexpr double kConvergencePx = 0.01;  // a step that ends the iteration
constexpr double kMinEigenvalue = 1e-4;  // least texture, in OpenCV's scale

struct Flow {
  std::vector<cv::Point2f> points;
  std::vector<uint8_t> found;
};

Flow RunFlow(const FlowPyramid& from, const FlowPyramid& to, const std::vector<cv::Point2f>& points,
             const std::vector<cv::Point2f>& guesses, const FlowOptions& options) {
  Flow flow{guesses, {}};
  std::vector<float> errors;
  const cv::TermCriteria criteria(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, kMaxIterations,
                                  kConvergencePx);
  cv::calcOpticalFlowPyrLK(from.levels, to.levels, points, flow.points, flow.found, errors,
                           cv::Size(options.window_px, options.window_px), options.levels, criteria,
                           cv::OPTFLOW_USE_INITIAL_FLOW, kMinEigenvalue);
  return flow;
}

bool IsInside(const cv::Point2f& point, const cv::Size& size) {
  return point.x >= 0.0f && point.y >= 0.0f && point.x <= static_cast<float>(size.width - 1) &&
         point.y <= static_cast<float>(size.height - 1);
}

}  // namespace

FlowPyramid BuildFlowPyramid(const cv::Mat& grey, const FlowOptions& options) {
  FlowPyramid pyramid;
  pyramid.size = grey.size();
  cv::buildOpticalFlowPyramid(grey, pyramid.levels, cv::Size(options.window_px, options.window_px),
                              options.levels);
  return pyramid;
}

std::vector<std::optional<cv::Point2f>> TrackPoints(const FlowPyramid& a, const FlowPyramid& b,
                                                    const std::vector<cv::Point2f>& points_in_a,
                                                    const std::vector<cv::Point2f>& guesses_in_b,
                                                    const FlowOptions& options) {
  ROVIO_CHECK(guesses_in_b.empty() || guesses_in_b.size() == points_in_a.size());
  std::vector<std::optional<cv::Point2f>> result(points_in_a.size());
  if (points_in_a.empty() || a.size != b.size) return result;
  const Flow there =
      RunFlow(a, b, points_in_a, guesses_in_b.empty() ? points_in_a : guesses_in_b, options);
  const Flow back = RunFlow(b, a, there.points, points_in_a, options);
  for (size_t i = 0; i < result.size(); ++i) {
    if (!there.found[i] || !back.found[i] || !IsInside(there.points[i], b.size)) continue;
    if (cv::norm(back.points[i] - points_in_a[i]) > options.max_backward_error_px) continue;
    result[i] = there.points[i];
  }
  return result;
}

}  // namespace rovio_sfm
