#include "rovio_sfm/features/extract_options.h"

namespace rovio_sfm {

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
