#include "rovio_sfm/app/map_formats.h"

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace rovio_sfm {
namespace {

struct FormatRow {
  MapFormat format;
  const char* name;
  const char* main_path;
  FormatSource source;
  bool takes_long = false;
};

constexpr std::array<FormatRow, 13> kFormats = {{
    {MapFormat::kTum, "tum", "trajectory.txt", FormatSource::kMap},
    {MapFormat::kPly, "ply", "cloud.ply", FormatSource::kMap},
    {MapFormat::kPlyAscii, "ply_ascii", "cloud_ascii.ply", FormatSource::kMap},
    {MapFormat::kKitti, "kitti", "kitti", FormatSource::kMap},
    {MapFormat::kColmap, "colmap", "colmap", FormatSource::kModel},
    {MapFormat::kColmapText, "colmap_text", "colmap_text", FormatSource::kModel},
    {MapFormat::kBundler, "bundler", "bundler", FormatSource::kModel},
    {MapFormat::kNvm, "nvm", "nvm", FormatSource::kModel},
    {MapFormat::kDensified, "densified", "densified.ply", FormatSource::kFinished, true},
    {MapFormat::kDense, "dense", "dense.ply", FormatSource::kFinished, true},
    {MapFormat::kMesh, "mesh", "mesh.ply", FormatSource::kFinished, true},
    {MapFormat::kReport, "report", "report.html", FormatSource::kFinished},
    {MapFormat::kGrid, "grid", "map.yaml", FormatSource::kFinished},
}};

const FormatRow& RowOf(MapFormat format) {
  return *std::find_if(kFormats.begin(), kFormats.end(),
                       [format](const FormatRow& row) { return row.format == format; });
}

std::optional<MapFormat> FindFormat(const std::string& name) {
  for (const FormatRow& row : kFormats) {
    if (name == row.name) return row.format;
  }
  return std::nullopt;
}

}  // namespace

std::string FormatNames() {
  std::string names;
  for (const FormatRow& row : kFormats)
    names += (names.empty() ? "" : ", ") + std::string(row.name);
  return names;
}

MapFormats ReadFormats(const std::string& names, const std::string& field) {
  if (names.empty()) return kDefaultFormats;
  MapFormats formats;
  std::istringstream stream(names + ",");  // so that a comma at the end is seen
  for (std::string name; std::getline(stream, name, ',');) {
    const std::optional<MapFormat> format = FindFormat(name);
    if (!format) {
      throw std::runtime_error(field + " = " + names + ": expected one or more of " +
                               FormatNames() + ", with commas between them, got \"" + name + "\"");
    }
    formats.insert(*format);
  }
  return formats;
}

FormatSource SourceOf(MapFormat format) { return RowOf(format).source; }

bool TakesLong(MapFormat format) { return RowOf(format).takes_long; }

std::string MainPathOf(MapFormat format) { return RowOf(format).main_path; }

}  // namespace rovio_sfm
