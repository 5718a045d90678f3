#include "rovio_sfm/merging/map_options.h"

namespace rovio_sfm {

bool MapOptions::IsValid(std::string* error) const {
  return MapperOptions::IsValid(error) && merge.IsValid(error);
}

}  // namespace rovio_sfm
