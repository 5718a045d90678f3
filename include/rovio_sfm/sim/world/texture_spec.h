#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace rovio_sfm::sim {

// How to draw a texture: a natural 1/f ground of two colours, with marks upon it.
struct TextureSpec {
  std::string name;
  uint64_t seed = 0;
  int width_px = 512, height_px = 512;  // 8 … 4096
  double texel_m = 0.003;               // (0, 0.1]
  cv::Vec3b color{128, 128, 128};       // RGB
  cv::Vec3b accent{96, 96, 96};         // RGB; the other end of the ground's range
  double contrast = 0.2;           // of the ground between the colours, 0 … 2; ≤ 0.05 is plain
  double stretch = 1.0;            // of the ground along x, 0.02 … 50
  double patches = 0.0;            // share covered by sharp-edged patches of the accent, 0 … 0.9
  std::vector<std::string> marks;  // names of KnownMarks, drawn in order
  double density = 1.0;            // of the marks, 0 … 4
  double period_px = 64.0;         // of the periodic marks (tiles, bricks, holes), 4 … 1024

  // Names the field, its value and what was expected.
  bool IsValid(std::string* error) const;
};

// text posters shapes labels dials books scratches holes tiles bricks chips circuit
const std::vector<std::string>& KnownMarks();

}  // namespace rovio_sfm::sim
