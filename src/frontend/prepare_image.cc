#include "rovio_sfm/frontend/prepare_image.h"

#include <opencv2/imgproc.hpp>
#include <utility>

#include "rovio_sfm/features/blur.h"
#include "rovio_sfm/features/decode_image.h"
#include "rovio_sfm/features/denoise.h"
#include "rovio_sfm/features/extract_features.h"

namespace rovio_sfm {
namespace {

// Decodes into image, or returns why not.
std::string Decode(const ImageEvent& event, const FrontendOptions& options, cv::Mat* image) {
  std::string error;
  if (!event.camera.IsValid(&error)) return error;
  if (event.encoded == nullptr) return "no image data";
  DecodeResult decoded = DecodeImage(*event.encoded, options.max_pixels);
  if (!decoded.reason.empty()) return decoded.reason;
  if (decoded.bgr.cols != event.camera.width || decoded.bgr.rows != event.camera.height) {
    return "image of " + std::to_string(decoded.bgr.cols) + "x" + std::to_string(decoded.bgr.rows) +
           " px: expected the camera's " + std::to_string(event.camera.width) + "x" +
           std::to_string(event.camera.height);
  }
  *image = std::move(decoded.bgr);
  return "";
}

}  // namespace

PreparedImage PrepareImage(const ImageEvent& event, const FrontendOptions& options) {
  PreparedImage image;
  image.event = event;
  image.refusal = Decode(event, options, &image.bgr);
  if (!image.refusal.empty()) return image;
  cv::Mat grey, small;
  cv::cvtColor(image.bgr, grey, cv::COLOR_BGR2GRAY);
  cv::resize(grey, small, cv::Size(), 0.5, 0.5, cv::INTER_AREA);
  image.sharpness = SharpnessScore(small);
  if (options.choose.mode == KeyframeMode::kEvery) {
    image.features = FindFeatures(image.bgr, event.camera, options);
    return image;
  }
  image.small = BuildFlowPyramid(small, MotionTracker::PyramidOptions());
  if (options.light.enabled) image.full = BuildFlowPyramid(grey, options.light.flow);
  return image;
}

std::shared_ptr<const FrameFeatures> FindFeatures(const cv::Mat& bgr, const Camera& camera,
                                                  const FrontendOptions& options) {
  return std::make_shared<const FrameFeatures>(
      ExtractFeatures(Denoise(bgr, options.denoise), camera, options.extract));
}

}  // namespace rovio_sfm
