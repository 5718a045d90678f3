#pragma once

#include <string>

#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// What ExtractFeatures finds in an image (§3.3).
struct ExtractOptions {
  DescriptorType type = DescriptorType::kSift;  // kNone is refused
  int max_features = 1000;
  double candidate_factor = 1.25;
  double sift_contrast = 0.004;
  double sift_edge = 10.0;
  double sift_size_exponent = 0.75;
  bool upsample = true;
  int orb_threshold = 7;
  double akaze_threshold = 3e-4;
  double surf_threshold = 8.0;
  int cell_px = 48;
  double min_distance_px = 2.0;
  int border_px = 3;
  bool fill_with_corners = false;  // SIFT: where the extrema do not fill max_features; no option

  void DescribeOptions(OptionTable& table) {
    table.AddChoice("type", type,
                    {{"sift", DescriptorType::kSift},
                     {"orb", DescriptorType::kOrb},
                     {"akaze", DescriptorType::kAkaze},
                     {"surf", DescriptorType::kSurf}},
                    "of features and descriptors");
    table.AddLiveNumber("max_features", max_features, 16, 20000,
                        "of an image; at 1000 a keyframe event stays below 200 kB");
    table.AddNumber("candidate_factor", candidate_factor, 1.0, 10.0, "of max_features, to choose");
    table.AddLiveNumber("sift_contrast", sift_contrast, 1e-4, 0.2,
                        "least; low, because the spread chooses");
    table.AddNumber("sift_edge", sift_edge, 2.0, 100.0, "greatest edge ratio");
    table.AddNumber("sift_size_exponent", sift_size_exponent, 0.0, 2.0,
                    "strength is contrast times size to this power");
    table.AddFlag("upsample", upsample, "SIFT: also features of the doubled image");
    table.AddNumber("orb_threshold", orb_threshold, 1, 100, "least FAST contrast, grey levels");
    table.AddNumber("akaze_threshold", akaze_threshold, 1e-6, 0.1, "least response");
    table.AddNumber("surf_threshold", surf_threshold, 0.1, 1000.0, "least response, dlib's scale");
    table.AddNumber("cell_px", cell_px, 8, 1024, "side of a cell of the even spread");
    table.AddLiveNumber("min_distance_px", min_distance_px, 0.0, 50.0, "nearer features are one");
    table.AddNumber("border_px", border_px, 0, 100, "no features nearer to the image's edge");
  }
};

// "sift", "orb", "akaze" or "surf"; nothing for any other name.
std::optional<DescriptorType> DescriptorTypeFromName(const std::string& name);
std::string NameOfDescriptorType(DescriptorType type);

}  // namespace rovio_sfm
