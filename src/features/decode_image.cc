#include "rovio_sfm/features/decode_image.h"

#include <algorithm>
#include <array>
#include <opencv2/imgcodecs.hpp>
#include <string_view>

#include "rovio_sfm/util/jpeg_check.h"

namespace rovio_sfm {
namespace {

constexpr std::array<uint8_t, 8> kPngSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr uint8_t kStartOfImage = 0xd8;

bool IsJpeg(const std::vector<uint8_t>& bytes) {
  return bytes.size() > 4 && bytes[0] == 0xff && bytes[1] == kStartOfImage && bytes[2] == 0xff;
}

std::string_view TextOf(const std::vector<uint8_t>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool IsPng(const std::vector<uint8_t>& bytes) {
  return bytes.size() > 24 && std::equal(kPngSignature.begin(), kPngSignature.end(), bytes.begin());
}

int BigEndian16(const std::vector<uint8_t>& bytes, size_t at) {
  return (bytes[at] << 8) | bytes[at + 1];
}

std::optional<ImageSize> PngSize(const std::vector<uint8_t>& bytes) {
  if (!std::equal(bytes.begin() + 12, bytes.begin() + 16, "IHDR")) return std::nullopt;
  const auto side = [&](size_t at) {
    return (static_cast<int64_t>(BigEndian16(bytes, at)) << 16) | BigEndian16(bytes, at + 2);
  };
  if (side(16) > INT32_MAX || side(20) > INT32_MAX) return std::nullopt;
  return ImageSize{static_cast<int>(side(16)), static_cast<int>(side(20))};
}

// Sensors of 10, 12 or 14 bits fill the lower ones of 16: the topmost bit in use becomes the
// topmost of eight, or every picture would be almost black.
cv::Mat EightBitsOf(const cv::Mat& bgr) {
  double brightest = 0.0;
  cv::minMaxLoc(bgr.reshape(1), nullptr, &brightest);
  int num_bits = 8;
  while (num_bits < 16 && brightest >= static_cast<double>(1 << num_bits)) ++num_bits;
  cv::Mat eight_bits;
  bgr.convertTo(eight_bits, CV_8U, 1.0 / (1 << (num_bits - 8)));
  return eight_bits;
}

DecodeResult RefuseImage(const std::string& reason) { return {cv::Mat(), reason}; }

}  // namespace

std::optional<ImageSize> EncodedImageSize(const std::vector<uint8_t>& encoded) {
  std::optional<ImageSize> size;
  if (IsJpeg(encoded)) {
    const JpegInfo info = CheckJpegMarkers(TextOf(encoded), SIZE_MAX);
    size = ImageSize{info.width_px, info.height_px};
  }
  if (IsPng(encoded)) size = PngSize(encoded);
  if (!size || size->width <= 0 || size->height <= 0) return std::nullopt;
  return size;
}

DecodeResult DecodeImage(const std::vector<uint8_t>& encoded, int64_t max_pixels) {
  const auto size = EncodedImageSize(encoded);
  if (!size) return RefuseImage("no JPEG or PNG with a readable header");
  if (static_cast<int64_t>(size->width) * size->height > max_pixels) {
    return RefuseImage("image of " + std::to_string(size->width) + "x" +
                       std::to_string(size->height) + " px: expected at most " +
                       std::to_string(max_pixels) + " pixels");
  }
  if (IsJpeg(encoded)) {
    const JpegInfo info = CheckJpeg(TextOf(encoded), static_cast<size_t>(max_pixels));
    if (info.fault != JpegFault::kNone)
      return RefuseImage(std::string("JPEG ") + NameOf(info.fault));
  }
  try {
    cv::Mat bgr = cv::imdecode(
        encoded, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION | cv::IMREAD_ANYDEPTH);
    if (bgr.depth() == CV_16U) bgr = EightBitsOf(bgr);
    if (bgr.empty()) return RefuseImage("image data cannot be decoded");
    if (bgr.cols != size->width || bgr.rows != size->height)
      return RefuseImage("size is contradictory");
    return {bgr, ""};
  } catch (const cv::Exception& exception) {
    return RefuseImage("image data cannot be decoded: " + exception.err);
  }
}

}  // namespace rovio_sfm
