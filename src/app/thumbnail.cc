#include "rovio_sfm/app/thumbnail.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "rovio_sfm/features/decode_image.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kMaxPixels = 20'000'000;
constexpr int kQuality = 80;  // per cent

}  // namespace

std::optional<std::string> ThumbnailOf(const std::vector<uint8_t>& encoded, int max_width,
                                       std::string* error) {
  const DecodeResult picture = DecodeImage(encoded, kMaxPixels);
  if (picture.bgr.empty()) {
    *error = picture.reason;
    return std::nullopt;
  }
  const int width = std::min(picture.bgr.cols, max_width);
  const int height = std::max(1, picture.bgr.rows * width / picture.bgr.cols);
  cv::Mat small;
  cv::resize(picture.bgr, small, {width, height}, 0.0, 0.0, cv::INTER_AREA);
  std::vector<uint8_t> jpeg;
  cv::imencode(".jpg", small, jpeg, {cv::IMWRITE_JPEG_QUALITY, kQuality});
  return std::string(jpeg.begin(), jpeg.end());
}

}  // namespace rovio_sfm
