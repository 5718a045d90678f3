#include "rovio_sfm/features/extract_options.h"

#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm {

bool ExtractOptions::IsValid(std::string* error) const {
  OptionChecker checker("extract", error);
  checker.True("type", type != DescriptorType::kNone, "sift, orb, akaze or surf");
  checker.Range("max_features", max_features, 16, 20000);
  checker.Range("candidate_factor", candidate_factor, 1.0, 10.0);
  checker.Range("sift_contrast", sift_contrast, 1e-4, 0.2);
  checker.Range("sift_edge", sift_edge, 2.0, 100.0);
  checker.Range("orb_threshold", orb_threshold, 1, 100);
  checker.Range("akaze_threshold", akaze_threshold, 1e-6, 0.1);
  checker.Range("surf_threshold", surf_threshold, 0.1, 1000.0);
  checker.Range("cell_px", cell_px, 8, 1024);
  checker.Range("min_distance_px", min_distance_px, 0.0, 50.0);
  checker.Range("border_px", border_px, 0, 100);
  return checker.Passed();
}

std::optional<DescriptorType> DescriptorTypeFromName(const std::string& name) {
  for (const DescriptorType type : {DescriptorType::kSift, DescriptorType::kOrb,
                                    DescriptorType::kAkaze, DescriptorType::kSurf}) {
    if (name == NameOfDescriptorType(type)) return type;
  }
  return std::nullopt;
}

std::string NameOfDescriptorType(DescriptorType type) {
  switch (type) {
    case DescriptorType::kSift:
      return "sift";
    case DescriptorType::kOrb:
      return "orb";
    case DescriptorType::kAkaze:
      return "akaze";
    case DescriptorType::kSurf:
      return "surf";
    case DescriptorType::kNone:
      break;
  }
  return "none";
}

}  // namespace rovio_sfm
