#include "rovio_sfm/app/write_map_files.h"

#include <map>
#include <optional>
#include <ostream>
#include <set>
#include <stdexcept>

#include "rovio_sfm/app/finish_map.h"
#include "rovio_sfm/io/export_kitti.h"
#include "rovio_sfm/io/export_ply.h"
#include "rovio_sfm/io/named_file.h"
#include "rovio_sfm/report/drive_names.h"
#include "rovio_sfm/report/level_session.h"

namespace rovio_sfm {
namespace {

namespace fs = std::filesystem;

struct DrivePoses {
  std::string name;
  std::vector<StampedPose> poses;
};

// By drive.
std::vector<DrivePoses> PosesByDrive(const LevelMap& map) {
  std::map<DriveId, std::vector<StampedPose>> poses;
  std::set<DriveId> drives;
  for (const PosedImage& image : PosedImages(map)) {
    poses[image.id.drive].push_back(image.level_from_camera);
    drives.insert(image.id.drive);
  }
  const std::map<DriveId, std::string> names = DriveNames(drives);
  std::vector<DrivePoses> list;
  for (auto& [drive, drive_poses] : poses)
    list.push_back({names.at(drive), std::move(drive_poses)});
  return list;
}

std::string UnitOf(const LevelMap& map) { return map.scale ? "metres" : "map units"; }

std::vector<NamedFile> TumFiles(const LevelMap& map) {
  std::vector<NamedFile> files = {{MainPathOf(MapFormat::kTum), MapTrajectoryText(map)}};
  const std::vector<DrivePoses> drives = PosesByDrive(map);
  for (const DrivePoses& drive : drives) {
    if (drives.size() == 1) continue;
    files.push_back({"trajectory_" + drive.name + ".txt", TrajectoryText(drive.poses)});
  }
  return files;
}

// All drives from the first image of the map.
std::vector<NamedFile> KittiFiles(const LevelMap& map) {
  std::vector<NamedFile> files;
  const std::vector<DrivePoses> drives = PosesByDrive(map);
  for (const DrivePoses& drive : drives) {
    const StampedPose& first = drives.front().poses.front();
    const std::string stem = MainPathOf(MapFormat::kKitti) + "/" + drive.name;
    files.push_back({stem + "_poses.txt", KittiPosesText(drive.poses, first.reference_from_body)});
    files.push_back({stem + "_times.txt", KittiTimesText(drive.poses, first.stamp_ns)});
  }
  return files;
}

std::vector<NamedFile> FilesOf(const LevelMap& map, MapFormat format) {
  if (format == MapFormat::kTum) return TumFiles(map);
  if (format == MapFormat::kKitti) return KittiFiles(map);
  if (format == MapFormat::kPly) return {{MainPathOf(format), MapCloudBytes(map)}};
  return {{MainPathOf(format), PlyText(LevelCloud(map), UnitOf(map))}};
}

bool IsFinished(MapFormat format) {
  return format == MapFormat::kDense || format == MapFormat::kMesh;
}

std::vector<NamedFile> FinishedFiles(MapFormat format, const std::string& unit, FinishedMap* map) {
  const std::string bytes = format == MapFormat::kDense ? DensePlyBytes(map->DenseCloud(), unit)
                                                        : MeshPlyBytes(map->Surface(), unit);
  return {{MainPathOf(format), bytes}};
}

WrittenFiles WriteFiles(const std::vector<NamedFile>& files, const fs::path& folder,
                        Overwrite overwrite) {
  WrittenFiles written;
  for (const NamedFile& file : files) {
    const fs::path path = fs::absolute(folder / file.name);
    fs::create_directories(path.parent_path());
    WriteFile(path, file.content, overwrite);
    written.paths.push_back(path);
  }
  return written;
}

}  // namespace

std::string MapTrajectoryText(const LevelMap& map) {
  std::map<int64_t, StampedPose> poses;  // the first drive's where several have a stamp
  for (const PosedImage& image : PosedImages(map)) {
    poses.emplace(image.level_from_camera.stamp_ns, image.level_from_camera);
  }
  std::vector<StampedPose> rising;
  for (const auto& [stamp_ns, pose] : poses) rising.push_back(pose);
  return TrajectoryText(rising);
}

std::string MapCloudBytes(const LevelMap& map) { return PlyBytes(LevelCloud(map), UnitOf(map)); }

void RequireNoFiles(const fs::path& folder, const MapFormats& formats) {
  for (const MapFormat format : formats) {
    const fs::path path = fs::absolute(folder / MainPathOf(format));
    if (fs::exists(path)) throw std::runtime_error(path.string() + " exists: not overwritten");
  }
}

WrittenFiles WriteMapFiles(const LevelMap& map, const MapSource& source, const MapFormats& formats,
                           const fs::path& folder, Overwrite overwrite) {
  if (overwrite == Overwrite::kRefuse) RequireNoFiles(folder, formats);
  WrittenFiles all;
  std::optional<MapModel> model;
  std::optional<FinishedMap> finished;
  for (const MapFormat format : formats) {
    if (NeedsModel(format) && !model) {
      model = source.model_of(map);
      finished.emplace(*model, source.pictures);
    }
    const WrittenFiles written =
        IsFinished(format)
            ? WriteFiles(FinishedFiles(format, UnitOf(map), &*finished), folder, overwrite)
        : NeedsModel(format) ? WriteModelFiles(*model, format, source.pictures, folder, overwrite)
                             : WriteFiles(FilesOf(map, format), folder, overwrite);
    all.paths.insert(all.paths.end(), written.paths.begin(), written.paths.end());
    all.num_missing_pictures += written.num_missing_pictures;
  }
  return all;
}

void PrintWritten(const WrittenFiles& written, std::ostream& out) {
  for (const fs::path& path : written.paths) out << "wrote " << path.string() << "\n";
  if (written.num_missing_pictures > 0) {
    out << written.num_missing_pictures << " pictures were not at hand and are not among them\n";
  }
}

std::string LocalizedText(const MapSnapshot& snapshot,
                          const std::map<FrameId, Localization>& localizations) {
  std::vector<StampedPose> poses;
  for (const auto& [id, pose] : localizations) {
    const SessionSnapshot* session = FindSession(snapshot, pose.session);
    const auto map = session == nullptr ? std::nullopt : FindLevelMap(snapshot, session->map);
    if (!map) continue;
    const Sim3 level_from_session = map->level_from_map * session->map_from_session;
    poses.push_back(
        {pose.stamp_ns, Inverse(TransformCamera(level_from_session, pose.cam_from_session))});
  }
  return TrajectoryText(poses);
}

}  // namespace rovio_sfm
