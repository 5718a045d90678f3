#pragma once

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>

#include "rovio_sfm/app/map_formats.h"
#include "rovio_sfm/app/offline_mapper.h"
#include "rovio_sfm/app/store_folder.h"
#include "rovio_sfm/io/write_file.h"

namespace CLI {
class App;
}

namespace rovio_sfm {

// What every command that maps drives can be told.
struct MappingArguments {
  std::string out;                       // folder for the results
  std::string frontend_file;             // options, YAML; empty: as they are
  std::string mapper_file;               // the same
  std::string mode;                      // every, parallax; empty: as the options say
  std::optional<int> features;           // most of an image; none: as the options say
  std::string places;                    // place model; none: no merging; empty: the shipped one
  std::string format;                    // names of ReadFormats
  MapFormats formats = kDefaultFormats;  // of that
  bool densify = false;                  // format densified too
  bool overwrite = false;
  bool resume = false;
  bool store = true;
  OfflineMapperOptions mapper;
};

// The arguments must outlive the parsing.
void DeclareMappingArguments(CLI::App* app, MappingArguments* arguments);

// Reads the files of options, then puts mode, features and seed into them, and reads the formats.
// Throws std::runtime_error that names what cannot be read or is out of its range.
void CompleteMappingArguments(MappingArguments* arguments);

// The store in the folder for the results; null where none is wanted. Throws std::runtime_error as
// StoreFolder does.
std::unique_ptr<StoreFolder> OpenResultStore(const MappingArguments& arguments);
// That of a command that ends, for people; a warning where it could not be written to the end.
void TellStore(const StoreFolder* store, std::ostream& out);
// Of --localize: writes the poses of the images, and says how many there are, what was left out
// and, where there is none, why. Returns the exit status: then 2.
int WriteLocalized(const OfflineMapper& mapper, const MapSnapshot& snapshot,
                   const ReasonCounts& left_out, const MappingArguments& arguments,
                   std::ostream& out);
// Whether files that a folder for results holds already may be replaced.
Overwrite MayReplaceResults(const MappingArguments& arguments);

}  // namespace rovio_sfm
