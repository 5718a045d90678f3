#pragma once

#include "rovio_sfm/mapping/mapper_options.h"
#include "rovio_sfm/merging/merge_options.h"

namespace rovio_sfm {

// How maps are made: each drive by itself, and of several sessions together.
struct MapOptions : MapperOptions {
  MergeOptions merge;

  void DescribeOptions(OptionTable& table) {
    MapperOptions::DescribeOptions(table);
    table.AddGroup("merge", merge, "when and how sessions are joined (§4.3)");
  }
};

}  // namespace rovio_sfm
