#pragma once

namespace rovio_sfm {

// The robot's manual motions; values are those of the wire.
enum class DriveCode : int {
  kStop = 0,
  kForward = 1,
  kBackward = 2,
  kLeft = 3,
  kRight = 4,
  kRotateLeft = 5,
  kRotateRight = 6,
  kForwardLeft = 7,
  kForwardRight = 8,
  kBackwardLeft = 9,
  kBackwardRight = 10,
};

inline constexpr int kFastestSpeed = 1;
inline constexpr int kSlowestSpeed = 10;

}  // namespace rovio_sfm
