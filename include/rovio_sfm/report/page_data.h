#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "rovio_sfm/report/level_map.h"
#include "rovio_sfm/scene/map_model.h"
#include "rovio_sfm/scene/merge_report.h"
#include "rovio_sfm/scene/point_cloud.h"

namespace rovio_sfm {

// What is told of a map beside the map itself.
struct PageNotes {
  std::vector<MergeReport> merges;
  std::vector<std::pair<std::string, double>> stage_ms = {};      // time by stage, per image
  std::vector<std::string> warnings = {};                         // sentences
  std::vector<std::pair<std::string, std::string>> figures = {};  // more rows: name, value
};

// What the page of a map shows (docs/finish.md), as JSON: figures, histograms, paths, cameras,
// overlaps, merges; cloud, dense cloud and mesh as base64 of little-endian arrays, thinned evenly
// to at most kMaxPagePoints points each, a mesh of more than kMaxPageTriangles left out and told.
// dense and mesh may be null.
std::string PageDataJson(const LevelMap& map, const MapModel& model, const PageNotes& notes,
                         const PointCloud* dense, const TriangleMesh* mesh);

inline constexpr size_t kMaxPagePoints = 150'000, kMaxPageTriangles = 300'000;

}  // namespace rovio_sfm
