#pragma once

#include <string>

#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/merging/merge_options.h"

namespace rovio_sfm {

// How maps are made: each drive by itself, and of several sessions together.
struct MapOptions : MapperOptions {
  MergeOptions merge;

  // Names the field, its value and its bound.
  bool IsValid(std::string* error) const;
};

}  // namespace rovio_sfm
