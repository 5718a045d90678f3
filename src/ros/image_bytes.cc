#include "rovio_sfm/ros/image_bytes.h"

#include <cv_bridge/cv_bridge.h>
#include <sensor_msgs/image_encodings.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace rovio_sfm {
namespace {

constexpr size_t kMaxBytes = 64u << 20;
constexpr uint32_t kMaxSide = 16384;  // px, as Camera::IsValid has it
constexpr int kFastestPng = 1;

bool IsJpeg(const std::vector<uint8_t>& data) { return data[0] == 0xFF && data[1] == 0xD8; }
bool IsPng(const std::vector<uint8_t>& data) { return data[0] == 0x89 && data[1] == 'P'; }

// At least; of encodings that cv_bridge knows it checks itself.
uint32_t BytesPerPixel(const std::string& encoding) { return encoding == "yuv422_yuy2" ? 2 : 1; }

// The size fields agree with the data, so that cv_bridge reads nothing beyond them.
bool HasConsistentSize(const sensor_msgs::Image& message) {
  const uint64_t needed = static_cast<uint64_t>(message.step) * message.height;
  return message.width > 0 && message.width <= kMaxSide && message.height > 0 &&
         message.height <= kMaxSide && message.data.size() == needed && needed <= kMaxBytes &&
         message.step >= message.width * BytesPerPixel(message.encoding);
}

// What the pixels are turned into: 16 bits stay so, for the decoder stretches them.
const char* PackedEncoding(const std::string& encoding) {
  namespace encodings = sensor_msgs::image_encodings;
  if (encoding == encodings::MONO8 || encoding == encodings::TYPE_8UC1) return "mono8";
  if (encoding == encodings::MONO16 || encoding == encodings::TYPE_16UC1) return "mono16";
  if (encodings::isColor(encoding) && encodings::bitDepth(encoding) == 16) return "bgr16";
  return "bgr8";
}

// As the colours of plain channels are, where a driver names their type alone.
std::string KnownEncoding(const std::string& encoding) {
  namespace encodings = sensor_msgs::image_encodings;
  if (encoding == encodings::TYPE_8UC1) return encodings::MONO8;
  if (encoding == encodings::TYPE_8UC3) return encodings::BGR8;
  if (encoding == encodings::TYPE_16UC1) return encodings::MONO16;
  return encoding;
}

cv::Mat PixelsOf(const sensor_msgs::Image& message) {
  const boost::shared_ptr<void const> none;
  if (message.encoding == "yuv422_yuy2") {  // cv_bridge came to know it later than drivers did
    const cv::Mat packed(static_cast<int>(message.height), static_cast<int>(message.width), CV_8UC2,
                         const_cast<uint8_t*>(message.data.data()), message.step);
    cv::Mat bgr;
    cv::cvtColor(packed, bgr, cv::COLOR_YUV2BGR_YUY2);
    return bgr;
  }
  const std::string encoding = KnownEncoding(message.encoding);
  if (encoding == message.encoding) {
    return cv_bridge::toCvShare(message, none, PackedEncoding(encoding))->image;
  }
  sensor_msgs::Image known = message;
  known.encoding = encoding;
  return cv_bridge::toCvCopy(known, PackedEncoding(encoding))->image;
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
    return EncodePng(PixelsOf(message));
  } catch (const std::exception& exception) {  // cv_bridge and OpenCV throw on odd encodings
    *error = "image encoding " + message.encoding + ": " + exception.what();
    return nullptr;
  }
}

}  // namespace rovio_sfm
