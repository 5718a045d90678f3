#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rovio_sfm/io/map_store.h"

namespace rovio_sfm {

struct StoreCopyReport {
  size_t num_frames = 0;
  size_t num_sessions = 0;
  size_t num_edits = 0;
  std::vector<std::string> lost;  // what could not be read, and why
};

// How keyframes and light frames are made where no mapping follows.
FrameMaker DefaultFrameMaker();

// Copies what reads of a map store into a new one. A session of which something does not read is
// left out, its frames stay; edits that name it are undone. Throws StoreError where the target is
// there already or cannot be written, std::runtime_error where it is the map.db of a folder that
// another process maps into.
StoreCopyReport RepairStore(const std::filesystem::path& from, const std::filesystem::path& to);

// Puts two map stores into a new one: first's as they are, then second's with session and edit
// numbers shifted behind them. Frames keep their ids. Throws StoreError where both hold frames of
// one drive, or something does not read.
StoreCopyReport MergeStores(const std::filesystem::path& first, const std::filesystem::path& second,
                            const std::filesystem::path& to);

}  // namespace rovio_sfm
