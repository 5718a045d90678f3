#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace rovio_sfm {

// What a map store holds, for people: drives, sessions, the maps they form, merges, what takes how
// much. Throws StoreError where it does not read.
void TellContents(const std::filesystem::path& file, std::ostream& out);

// Everything that is wrong with a map store: pages, references, columns, sessions. Empty: it is
// sound. Throws StoreError where it is none.
std::vector<std::string> FindStoreFaults(const std::filesystem::path& file);

// What may be forgotten to save space.
struct PruneChoice {
  bool images = false;       // exports with pictures, and dense maps, lack them
  bool descriptors = false;  // nothing is recognised in, merged with or localised by those drives
  std::vector<std::string> drives;  // by DriveId::ToString; empty: all
};

struct StorePruneReport {
  size_t num_rows = 0;  // that went
  uintmax_t bytes_before = 0, bytes_after = 0;
};

// Throws std::runtime_error for a drive that is not there, and where another process maps into the
// store.
StorePruneReport PruneStore(const std::filesystem::path& file, const PruneChoice& choice);

}  // namespace rovio_sfm
