#include "rovio_sfm/finish/gather_features.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "rovio_sfm/features/decode_image.h"
#include "rovio_sfm/features/extract_features.h"
#include "rovio_sfm/scene/append_feature.h"

namespace rovio_sfm {
namespace {

cv::Mat Decode(const std::vector<uint8_t>& picture, const Camera& camera, int64_t max_pixels) {
  const DecodeResult decoded = DecodeImage(picture, max_pixels);
  if (!decoded.reason.empty()) throw std::runtime_error("picture: " + decoded.reason);
  if (decoded.bgr.cols != camera.width || decoded.bgr.rows != camera.height) {
    throw std::runtime_error("picture of " + std::to_string(decoded.bgr.cols) + "x" +
                             std::to_string(decoded.bgr.rows) + " px: expected the camera's " +
                             std::to_string(camera.width) + "x" + std::to_string(camera.height));
  }
  return decoded.bgr;
}

bool IsNear(const Keypoint& keypoint, const std::vector<Keypoint>& others, double distance_px) {
  for (const Keypoint& other : others) {
    const double dx = double{keypoint.x_px} - double{other.x_px};
    const double dy = double{keypoint.y_px} - double{other.y_px};
    if (dx * dx + dy * dy < distance_px * distance_px) return true;
  }
  return false;
}

}  // namespace

FrameFeatures GatherFeatures(const FrameFeatures& stored, const std::vector<uint8_t>* picture,
                             const Camera& camera, const GatherOptions& options) {
  FrameFeatures gathered = stored;
  if (picture == nullptr) return gathered;
  ExtractOptions extract = options.extract;
  extract.type = stored.descriptors.type;
  extract.max_features =
      std::max(options.max_features, 2 * static_cast<int>(stored.keypoints.size()));
  extract.fill_with_corners = true;
  const cv::Mat bgr = Decode(*picture, camera, options.max_pixels);
  const FrameFeatures found = ExtractFeatures(Denoise(bgr, options.denoise), camera, extract);
  for (size_t i = 0; i < found.keypoints.size(); ++i) {
    if (IsNear(found.keypoints[i], stored.keypoints, options.min_distance_px)) continue;
    AppendFeature(found, i, &gathered);
  }
  return gathered;
}

}  // namespace rovio_sfm
