#include "rovio_sfm/report/page_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "rovio_sfm/report/drive_names.h"
#include "rovio_sfm/report/map_statistics.h"
#include "rovio_sfm/report/merges_json.h"
#include "rovio_sfm/util/base64.h"

namespace rovio_sfm {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kLongestTrack = 30;  // of the histogram; longer ones count there

// Positions and colours, as the page's buffers want them.
struct PointArrays {
  std::vector<float> positions;
  std::vector<uint8_t> colors;
  std::vector<uint8_t> sessions;  // index of the point's session; none where it has none

  void Add(const Eigen::Vector3f& x, const Rgb& color) {
    positions.insert(positions.end(), x.begin(), x.end());
    colors.insert(colors.end(), color.begin(), color.end());
  }

  Json ToJson() const {
    return {{"count", positions.size() / 3},
            {"positions", Base64Of(positions)},
            {"colors", Base64Of(colors)},
            {"sessions", Base64Of(sessions)}};
  }
};

size_t StepFor(size_t count) { return count / kMaxPagePoints + 1; }

std::map<uint32_t, uint8_t> IndexOfSessions(const LevelMap& map) {
  std::map<uint32_t, uint8_t> index;
  for (const SessionSnapshot& session : map.sessions) {
    index.emplace(session.id.value, static_cast<uint8_t>(index.size() % 256));
  }
  return index;
}

Json CloudJson(const LevelMap& map) {
  const std::map<uint32_t, uint8_t> index = IndexOfSessions(map);
  const std::vector<CloudPoint> cloud = LevelCloud(map);
  PointArrays arrays;
  for (size_t i = 0; i < cloud.size(); i += StepFor(cloud.size())) {
    arrays.Add(cloud[i].x_in_map.cast<float>(), cloud[i].color);
    arrays.sessions.push_back(index.at(cloud[i].session));
  }
  return arrays.ToJson();
}

Json DenseJson(const PointCloud* cloud) {
  if (cloud == nullptr) return nullptr;
  PointArrays arrays;
  for (size_t i = 0; i < cloud->size(); i += StepFor(cloud->size())) {
    arrays.Add((*cloud)[i].position, (*cloud)[i].color);
  }
  return arrays.ToJson();
}

Json MeshJson(const TriangleMesh* mesh) {
  if (mesh == nullptr || mesh->triangles.size() > kMaxPageTriangles) return nullptr;
  PointArrays arrays;
  for (const DensePoint& corner : mesh->vertices) arrays.Add(corner.position, corner.color);
  std::vector<uint32_t> indices;
  for (const auto& triangle : mesh->triangles) {
    indices.insert(indices.end(), triangle.begin(), triangle.end());
  }
  Json json = arrays.ToJson();
  json["triangles"] = mesh->triangles.size();
  json["indices"] = Base64Of(indices);
  return json;
}

// Rounded, so that text stays short; never what anybody computes with.
double Short(double value) { return std::round(value * 1e4) / 1e4; }

Json PoseJson(const Rigid3& map_from_cam) {
  const Eigen::Vector3d& t = map_from_cam.translation;
  const Eigen::Quaterniond& q = map_from_cam.rotation;
  return {Short(t.x()), Short(t.y()), Short(t.z()), Short(q.x()),
          Short(q.y()), Short(q.z()), Short(q.w())};
}

// A path a session: poses of its registered images by index, and which are keyframes.
Json PathsJson(const LevelMap& map) {
  std::set<DriveId> drives;
  for (const SessionSnapshot& session : map.sessions) drives.insert(session.drive);
  const std::map<DriveId, std::string> names = DriveNames(drives);
  Json paths = Json::array();
  for (const SessionSnapshot& session : map.sessions) {
    const Sim3 level_from_session = map.level_from_map * session.map_from_session;
    Json poses = Json::array(), keyframes = Json::array();
    for (const auto& block : session.frames) {
      for (const FrameSnapshot& frame : *block) {
        if (frame.weak) continue;
        poses.push_back(
            PoseJson(Inverse(TransformCamera(level_from_session, frame.cam_from_session))));
        keyframes.push_back(frame.kind == FrameKind::kKeyframe ? 1 : 0);
      }
    }
    paths.push_back({{"session", session.id.value},
                     {"drive", names.at(session.drive)},
                     {"poses", poses},
                     {"keyframes", keyframes}});
  }
  return paths;
}

// From camera to camera of each accepted overlap whose frames the map holds.
Json OverlapsJson(const MapModel& model, const PageNotes& notes) {
  std::map<FrameId, Eigen::Vector3d> centers;
  for (const ModelImage& image : model.images) centers[image.id] = OriginInA(image.cam_from_map);
  Json overlaps = Json::array();
  for (const MergeReport& merge : notes.merges) {
    const auto a = centers.find(merge.query), b = centers.find(merge.other);
    if (merge.verdict != MergeVerdict::kAccepted || a == centers.end() || b == centers.end())
      continue;
    overlaps.push_back({Short(a->second.x()), Short(a->second.y()), Short(a->second.z()),
                        Short(b->second.x()), Short(b->second.y()), Short(b->second.z())});
  }
  return overlaps;
}

// How many points have so many views, from 2 on (thesis, Fig. 5.3).
Json TrackHistogram(const MapModel& model) {
  std::vector<size_t> counts(kLongestTrack - 1, 0);
  for (const ModelPoint& point : model.points) {
    if (point.views.size() < 2) continue;
    ++counts[std::min(point.views.size(), kLongestTrack) - 2];
  }
  return counts;
}

// The mean reprojection error of each image, px, behind undistortion (thesis, Fig. 5.4).
Json ErrorByImage(const MapModel& model) {
  std::vector<double> sums(model.images.size(), 0.0);
  std::vector<size_t> counts(model.images.size(), 0);
  for (const ModelPoint& point : model.points) {
    for (const ModelView& view : point.views) {
      const ModelImage& image = model.images[view.image];
      const Eigen::Vector3d x = image.cam_from_map * point.x_in_map;
      const Eigen::Vector2d& seen = image.keypoints[view.keypoint].x_normalized;
      sums[view.image] += model.cameras[image.camera].MeanFocal() * (x.hnormalized() - seen).norm();
      ++counts[view.image];
    }
  }
  Json errors = Json::array();
  for (size_t i = 0; i < sums.size(); ++i) {
    errors.push_back(counts[i] == 0 ? 0.0 : Short(sums[i] / static_cast<double>(counts[i])));
  }
  return errors;
}

Json ViewsByImage(const MapModel& model) {
  std::vector<size_t> counts(model.images.size(), 0);
  for (const ModelPoint& point : model.points) {
    for (const ModelView& view : point.views) ++counts[view.image];
  }
  return counts;
}

Json FiguresJson(const LevelMap& map, const PageNotes& notes) {
  const MapStatistics statistics = ComputeMapStatistics(map);
  Json figures = {{"images", statistics.registered},
                  {"keyframes", statistics.registered_keyframes},
                  {"sessions", map.sessions.size()},
                  {"landmarks (3+ views)", statistics.landmarks},
                  {"landmarks of two views", statistics.landmarks_two_views},
                  {"landmarks (4+ views)", statistics.landmarks_over_three_views},
                  {"projections", statistics.projections},
                  {"mean error, px", Short(statistics.mean_error_px)},
                  {"RMS, px", Short(statistics.rms_counted_px)},
                  {"RMS_N", Short(statistics.rms_n)}};
  if (map.scale) {
    figures["scale from"] = map.scale->source;
    figures["scale, 1 sigma, %"] = Short(100.0 * map.scale->sigma_log);
  }
  for (const auto& [name, value] : notes.figures) figures[name] = value;
  return figures;
}

Json WarningsJson(const LevelMap& map, const TriangleMesh* mesh, const PageNotes& notes) {
  Json warnings = notes.warnings;
  if (!map.scale) warnings.push_back("The map is in map units, not in metres.");
  if (mesh != nullptr && mesh->triangles.size() > kMaxPageTriangles) {
    warnings.push_back("The mesh has " + std::to_string(mesh->triangles.size()) +
                       " triangles, too many for this page: see mesh.ply.");
  }
  return warnings;
}

}  // namespace

std::string PageDataJson(const LevelMap& map, const MapModel& model, const PageNotes& notes,
                         const PointCloud* dense, const TriangleMesh* mesh) {
  Json stages = Json::array();
  for (const auto& [stage, ms] : notes.stage_ms) stages.push_back({stage, Short(ms)});
  const Json page = {{"map", map.id.value},
                     {"unit", model.length_unit},
                     {"figures", FiguresJson(map, notes)},
                     {"warnings", WarningsJson(map, mesh, notes)},
                     {"tracks", TrackHistogram(model)},
                     {"errors", ErrorByImage(model)},
                     {"views", ViewsByImage(model)},
                     {"stages", stages},
                     {"merges", MergesJson(notes.merges)["reports"]},
                     {"paths", PathsJson(map)},
                     {"overlaps", OverlapsJson(model, notes)},
                     {"cloud", CloudJson(map)},
                     {"dense", DenseJson(dense)},
                     {"mesh", MeshJson(mesh)}};
  return page.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace rovio_sfm
