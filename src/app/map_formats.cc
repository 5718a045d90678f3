#include "rovio_sfm/app/map_formats.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>

namespace rovio_sfm {
namespace {

struct FormatRow {
  MapFormat format;
  const char* name;
  const char* main_path;
  bool needs_model;
};

constexpr std::array<FormatRow, 13> kFormats = {{
    {MapFormat::kTum, "tum", "trajectory.txt", false},
    {MapFormat::kPly, "ply", "cloud.ply", false},
    {MapFormat::kPlyAscii, "ply_ascii", "cloud_ascii.ply", false},
    {MapFormat::kKitti, "kitti", "kitti", false},
    {MapFormat::kColmap, "colmap", "colmap", true},
    {MapFormat::kColmapText, "colmap_text", "colmap_text", true},
    {MapFormat::kBundler, "bundler", "bundler", true},
    {MapFormat::kNvm, "nvm", "nvm", true},
    {MapFormat::kDensified, "densified", "densified.ply", true},
    {MapFormat::kDense, "dense", "dense.ply", true},
    {MapFormat::kMesh, "mesh", "mesh.ply", true},
    {MapFormat::kReport, "report", "report.html", true},
    {MapFormat::kGrid, "grid", "map.yaml", true},
}};

const FormatRow& RowOf(MapFormat format) {
  return *std::find_if(kFormats.begin(), kFormats.end(),
                       [format](const FormatRow& row) { return row.format == format; });
}

MapFormat ReadFormat(const std::string& name) {
  for (const FormatRow& row : kFormats) {
    if (name == row.name) return row.format;
  }
  throw std::runtime_error("format: expected one or more of " + FormatNames() +
                           ", with commas between them, got \"" + name + "\"");
}

}  // namespace

std::string FormatNames() {
  std::string names;
  for (const FormatRow& row : kFormats)
    names += (names.empty() ? "" : ", ") + std::string(row.name);
  return names;
}

MapFormats ReadFormats(const std::string& names) {
  if (names.empty()) return kDefaultFormats;
  MapFormats formats;
  std::istringstream stream(names + ",");  // so that a comma at the end is seen
  for (std::string name; std::getline(stream, name, ',');) formats.insert(ReadFormat(name));
  return formats;
}

bool NeedsModel(MapFormat format) { return RowOf(format).needs_model; }

bool TakesLong(MapFormat format) {
  return format == MapFormat::kDensified || format == MapFormat::kDense ||
         format == MapFormat::kMesh;
}

std::string MainPathOf(MapFormat format) { return RowOf(format).main_path; }

}  // namespace rovio_sfm
