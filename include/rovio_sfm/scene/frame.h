#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {

enum class DescriptorType : uint8_t { kNone = 0, kSift = 1, kOrb = 2, kAkaze = 3, kSurf = 4 };
enum class DescriptorMetric : uint8_t { kL2 = 0, kHamming = 1 };

// Descriptors of one frame, row by row: count * length bytes. RootSIFT is stored as 512 * value,
// rounded (L2); ORB and AKAZE as packed bits (Hamming); SURF as 64 values mapped to bytes (L2).
struct Descriptors {
  DescriptorType type = DescriptorType::kNone;
  DescriptorMetric metric = DescriptorMetric::kL2;
  uint32_t length = 0;  // bytes of one descriptor
  std::vector<uint8_t> data;

  size_t Count() const { return length == 0 ? 0 : data.size() / length; }
  const uint8_t* Row(size_t i) const { return data.data() + i * length; }
};

// A feature in the raw image, and where it lies on the plane z = 1.
struct Keypoint {
  float x_px = 0.0f, y_px = 0.0f;  // raw (distorted) pixel
  float size_px = 0.0f;            // diameter of the feature; its localisation error grows with it
  float angle_rad = 0.0f;
  float response = 0.0f;
  Eigen::Vector2d x_normalized = Eigen::Vector2d::Zero();  // undistorted, unit focal length
};

using Rgb = std::array<uint8_t, 3>;

// Keypoints and descriptors of one image; vectors of equal length (descriptors may be empty for a
// light frame).
struct FrameFeatures {
  std::vector<Keypoint> keypoints;
  std::vector<Rgb> colors;
  Descriptors descriptors;
};

// Of (x m, y m, yaw rad) in odom, row-major.
using OdometryCovariance = std::array<double, 9>;

// Wheel odometry at an image's stamp.
struct OdometrySample {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;         // odom_from_base in the plane
  std::optional<OdometryCovariance> covariance = {};  // nothing: not known
};

enum class FrameKind : uint8_t { kKeyframe = 0, kLight = 1 };

}  // namespace rovio_sfm
