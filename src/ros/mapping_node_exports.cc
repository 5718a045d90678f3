// What leaves MappingNode as a whole map: the service ExportMap, and what its actions work on; see
// mapping_node.h.
#include <exception>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "rovio_sfm/app/store_folder.h"
#include "rovio_sfm/ros/export_map.h"
#include "rovio_sfm/ros/kept_frames.h"
#include "rovio_sfm/ros/mapping_node.h"
#include "rovio_sfm/ros/status.h"

namespace rovio_sfm {
namespace {

constexpr char kDropped[] = "the call was refused: too many wait already, or the node ends";

}  // namespace

bool MappingNode::ExportMap(ExportMapRequest& request, ExportMapResponse& response) {
  if (request.formats.empty()) {
    response = ExportMapFiles(*engine_.Picture().snapshot, {}, options_.output_dir, request);
    finish_.RefreshGrid();
    return true;
  }
  MapParts parts;
  const auto take = [&] { parts = TakeMapParts(request); };
  if (!RunAndWait(take, kCallLane, &worker_)) {
    response.status = Internal(kDropped);
    return true;
  }
  KeptFrames frames = Frames();
  const MapSource source{[&](const LevelMap&) {
                           if (!parts.model) throw std::runtime_error(parts.error);
                           return std::move(*parts.model);
                         },
                         [&](const ModelImage& image) { return frames.ReadImage(image.id); },
                         PageNotes{*engine_.Picture().merges},
                         [&](const ModelImage& image) { return frames.ReadFeatures(image.id); }};
  response = ExportMapFiles(*parts.snapshot, source, options_.output_dir, request);
  finish_.RefreshGrid();
  return true;
}

// On the worker, so that both are of one moment; the files are written elsewhere.
MappingNode::MapParts MappingNode::TakeMapParts(const ExportMapRequest& request) const {
  MapParts parts{engine_.Picture().snapshot, std::nullopt, ""};
  try {
    const auto map = FindRequestedMap(*parts.snapshot, request);
    if (map) parts.model = engine_.ModelOf(*map);
  } catch (const std::exception& error) {
    parts.error = error.what();
  }
  return parts;
}

KeptFrames MappingNode::Frames() const {
  const std::string& output_dir = options_.output_dir;
  return {history_.Events(),
          output_dir.empty() ? std::filesystem::path() : StoreFolder::FileIn(output_dir)};
}

FinishSources MappingNode::SourcesOfActions() {
  FinishSources sources;
  sources.take = [this](uint32_t session) {
    TakenMap taken;
    taken.status = Internal(kDropped);
    RunAndWait([&] { taken = TakeMap(engine_, session); }, kCallLane, &worker_);
    return taken;
  };
  sources.picture = [this] { return engine_.Picture(); };
  sources.frames = [this] { return Frames(); };
  sources.output_dir = options_.output_dir;
  return sources;
}

}  // namespace rovio_sfm
