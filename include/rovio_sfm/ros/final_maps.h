#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rovio_sfm/app/write_maps.h"
#include "rovio_sfm/scene/map_snapshot.h"

namespace rovio_sfm {

// The maps that a node writes at its end, more than once: in its output folder, or, where that
// holds maps of an older run that may not be replaced, in run_2, run_3 and so on in it.
class FinalMaps {
 public:
  FinalMaps(const std::filesystem::path& output_dir, bool overwrite);

  // Replaces what was written before by the maps of the snapshot, whatever signals come; an error
  // is logged.
  void Write(const MapSnapshot& snapshot);
  // False where the last maps could not be written.
  bool IsWritten() const { return is_written_; }
  // Logs where what was written last is, and sentences on the scale.
  void Tell(const std::vector<std::string>& why_not_metric) const;

 private:
  std::filesystem::path folder_;
  Overwrite overwrite_;
  std::vector<WrittenMap> maps_;
  bool is_written_ = false;
};

}  // namespace rovio_sfm
