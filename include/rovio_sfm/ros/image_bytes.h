#pragma once

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace rovio_sfm {

using ImageBytes = std::shared_ptr<const std::vector<uint8_t>>;

// The encoded bytes of an image message, as an ImageEvent carries them; null where the message is
// malformed, and `error` says why. Only the first bytes of a compressed image are looked at: the
// frontend decodes, and checks before it does.
ImageBytes BytesOf(const sensor_msgs::CompressedImage& message, std::string* error);

// A raw image (mono8, mono16, rgb8, bgr8, yuv422_yuy2, 8UC1, 8UC3, 16UC1 and what cv_bridge turns
// into bgr8) is packed as PNG, losslessly.
ImageBytes BytesOf(const sensor_msgs::Image& message, std::string* error);

}  // namespace rovio_sfm
