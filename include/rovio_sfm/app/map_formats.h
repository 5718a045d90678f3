#pragma once

#include <set>
#include <string>

namespace rovio_sfm {

// What a map can be written as (docs/exports.md).
enum class MapFormat {
  kTum,
  kPly,
  kPlyAscii,
  kKitti,
  kColmap,
  kColmapText,
  kBundler,
  kNvm,
  kDensified,
  kDense,
  kMesh,
  kReport,
  kGrid
};
using MapFormats = std::set<MapFormat>;

// A trajectory and a cloud.
inline const MapFormats kDefaultFormats = {MapFormat::kTum, MapFormat::kPly};

// All names, for help and errors: "tum, ply, ply_ascii, …".
std::string FormatNames();
// Reads names with commas between them; an empty text stands for the default. Throws
// std::runtime_error that names what is not known, and the field that they came in.
MapFormats ReadFormats(const std::string& names, const std::string& field = "format");

// What a format is written from.
enum class FormatSource {
  kMap,      // poses or points
  kModel,    // cameras, features and points (MapModel)
  kFinished  // what is made of the model: dense cloud, surface, grid, page
};
FormatSource SourceOf(MapFormat format);
// True where making it takes long: it waits for the final map.
bool TakesLong(MapFormat format);
// The file or folder that is always there once a map was written so.
std::string MainPathOf(MapFormat format);

}  // namespace rovio_sfm
