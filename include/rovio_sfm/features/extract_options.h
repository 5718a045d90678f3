#pragma once

#include <string>

#include "rovio_sfm/scene/frame.h"

namespace rovio_sfm {

// What ExtractFeatures finds in an image (§3.3).
struct ExtractOptions {
  DescriptorType type = DescriptorType::kSift;  // kNone is refused
  int max_features = 1000;  // 16 to 20000; at 1000 a keyframe event stays below 200 kB
  // Candidates wanted before the even spread chooses, as a multiple of max_features; 1 to 10.
  double candidate_factor = 1.25;
  // Least contrast of a SIFT candidate (OpenCV's scale); low, because the spread chooses. 1e-4 to
  // 0.2
  double sift_contrast = 0.004;
  double sift_edge = 10.0;        // greatest edge ratio of a SIFT candidate; 2 to 100
  bool upsample = true;           // SIFT: also features of the doubled image (first octave -1)
  int orb_threshold = 7;          // least FAST contrast, grey levels; 1 to 100
  double akaze_threshold = 3e-4;  // least AKAZE response; 1e-6 to 0.1
  double surf_threshold = 8.0;    // least dlib SURF response; 0.1 to 1000
  int cell_px = 48;               // side of a cell of the even spread; 8 to 1024
  double min_distance_px = 2.0;   // nearer features are one (§6.2); 0 to 50
  int border_px = 3;              // no features nearer to the image's edge; 0 to 100

  bool IsValid(std::string* error) const;
};

// "sift", "orb", "akaze" or "surf"; nothing for any other name.
std::optional<DescriptorType> DescriptorTypeFromName(const std::string& name);
std::string NameOfDescriptorType(DescriptorType type);

}  // namespace rovio_sfm
