#pragma once

#include <cstdint>
#include <iosfwd>
#include <nlohmann/json_fwd.hpp>

#include "rovio_sfm/app/command_arguments.h"
#include "rovio_sfm/app/map_summary.h"
#include "rovio_sfm/app/write_map_files.h"
#include "rovio_sfm/util/stage_times.h"

namespace rovio_sfm {

constexpr int kNothingWritten = 1;     // exit status
constexpr int kNothingRegistered = 2;  // the same

// A command's run whose images have all been given to the mapper, or that was asked to stop.
struct RunToFinish {
  const MappingArguments* arguments = nullptr;
  OfflineMapper* mapper = nullptr;
  const StageTimes* times = nullptr;
  StoreFolder* store = nullptr;  // null: none
  PictureSource pictures;        // for formats that hold them
  int64_t start_ns = 0;          // of the steady clock
  MapRun run;                    // what the mapper does not know
};

// Before the run, cheap now and vexing after an hour's work. Throws std::runtime_error that names
// a result of an earlier run which may not be replaced.
void RefuseOlderResults(const MappingArguments& arguments);
// Makes the folder for the results, unless images are to be localized in what is not there, and
// proves that it can be written to and has room for so many. Throws std::runtime_error.
void PrepareMapFolder(const MappingArguments& arguments, size_t num_images);

// Writes all maps and summary.json, which begins with `header`, as they stand; then adjusts finally
// and writes again, so that nothing that ends the program meanwhile costs the maps. What was
// stopped before there was a map replaces nothing. Says what was written, what was left out and
// why. Returns the exit status: kNothingRegistered where no image is in a map, kNothingWritten
// where no map can be written in any format, that of a signal after one. Once a signal's budget is
// used up the program ends here.
int FinishRun(RunToFinish finish, const nlohmann::ordered_json& header, std::ostream& out);

}  // namespace rovio_sfm
