#include "rovio_sfm/ros/image_bytes.h"

#include <cv_bridge/cv_bridge.h>
#include <sensor_msgs/image_encodings.h>

#include <opencv2/imgcodecs.hpp>

namespace rovio_sfm {
namespace {

constexpr size_t kMaxBytes = 64u << 20;
constexpr uint32_t kMaxSide = 16384;  // px, as Camera::IsValid has it
constexpr int kFastestPng = 1;

bool IsJpeg(const std::vector<uint8_t>& data) { return data[0] == 0xFF && data[1] == 0xD8; }
bool IsPng(const std::vector<uint8_t>& data) { return data[0] == 0x89 && data[1] == 'P'; }

// The size fields agree with the data, so that cv_bridge reads nothing beyond them.
bool HasConsistentSize(const sensor_msgs::Image& message) {
  const uint64_t needed = static_cast<uint64_t>(message.step) * message.height;
  return message.width > 0 && message.width <= kMaxSide && message.height > 0 &&
         message.height <= kMaxSide && message.data.size() == needed && needed <= kMaxBytes;
}

ImageBytes EncodePng(const cv::Mat& image) {
  auto bytes = std::make_shared<std::vector<uint8_t>>();
  cv::imencode(".png", image, *bytes, {cv::IMWRITE_PNG_COMPRESSION, kFastestPng});
  return bytes;
}

}  // namespace

ImageBytes BytesOf(const sensor_msgs::CompressedImage& message, std::string* error) {
  const size_t size = message.data.size();
  if (size >= 4 && size <= kMaxBytes && (IsJpeg(message.data) || IsPng(message.data))) {
    return std::make_shared<const std::vector<uint8_t>>(message.data);
  }
  *error = "compressed image data: expected a JPEG or PNG of at most 64 MiB";
  return nullptr;
}

ImageBytes BytesOf(const sensor_msgs::Image& message, std::string* error) {
  if (!HasConsistentSize(message)) {
    *error = "image data: expected step * height bytes, at most 64 MiB";
    return nullptr;
  }
  try {
    const boost::shared_ptr<void const> none;
    const bool is_grey = message.encoding == sensor_msgs::image_encodings::MONO8;
    const auto* encoding = is_grey ? "mono8" : "bgr8";
    return EncodePng(cv_bridge::toCvShare(message, none, encoding)->image);
  } catch (const std::exception& exception) {  // cv_bridge and OpenCV throw on odd encodings
    *error = std::string("image encoding: ") + exception.what();
    return nullptr;
  }
}

}  // namespace rovio_sfm
