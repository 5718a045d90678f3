#include "rovio_sfm/app/write_map_files.h"

#include <algorithm>
#include <map>
#include <optional>
#include <ostream>
#include <regex>
#include <set>
#include <stdexcept>

#include "rovio_sfm/app/finish_map.h"
#include "rovio_sfm/app/map_file_list.h"
#include "rovio_sfm/app/write_page.h"
#include "rovio_sfm/finish/grid_files.h"
#include "rovio_sfm/io/export_kitti.h"
#include "rovio_sfm/io/export_ply.h"
#include "rovio_sfm/io/named_file.h"
#include "rovio_sfm/report/drive_names.h"
#include "rovio_sfm/report/level_session.h"
#include "rovio_sfm/util/count_text.h"

namespace rovio_sfm {
namespace {

namespace fs = std::filesystem;

constexpr char kTrajectory[] = "trajectory";

struct DrivePoses {
  std::string name;
  std::vector<StampedPose> poses;
};

// By drive.
std::vector<DrivePoses> PosesByDrive(const std::vector<PosedImage>& images) {
  std::map<DriveId, std::vector<StampedPose>> poses;
  std::set<DriveId> drives;
  for (const PosedImage& image : images) {
    poses[image.id.drive].push_back(image.level_from_camera);
    drives.insert(image.id.drive);
  }
  const std::map<DriveId, std::string> names = DriveNames(drives);
  std::vector<DrivePoses> list;
  for (auto& [drive, drive_poses] : poses)
    list.push_back({names.at(drive), std::move(drive_poses)});
  return list;
}

// Those that were found in the map, by drive, then by index.
std::vector<PosedImage> LocalizedImages(const MapSnapshot& snapshot, const LevelMap& map,
                                        const std::map<FrameId, Localization>& localizations) {
  std::vector<PosedImage> images;
  for (const auto& [id, pose] : localizations) {
    const SessionSnapshot* session = FindSession(snapshot, pose.session);
    if (session == nullptr || !(session->map == map.id)) continue;
    const Sim3 level_from_session = map.level_from_map * session->map_from_session;
    images.push_back(
        {id,
         FrameKind::kLight,
         {pose.stamp_ns, Inverse(TransformCamera(level_from_session, pose.cam_from_session))}});
  }
  return images;
}

std::string UnitOf(const LevelMap& map) { return map.scale ? "metres" : "map units"; }

// Poses by rising stamp, in STEM.txt; with several drives each has a file of its own beside it.
std::string JointText(const std::vector<PosedImage>& images, const std::string& stem) {
  std::map<int64_t, StampedPose> poses;  // the first drive's where several have a stamp
  for (const PosedImage& image : images) {
    poses.emplace(image.level_from_camera.stamp_ns, image.level_from_camera);
  }
  std::vector<StampedPose> rising;
  for (const auto& [stamp_ns, pose] : poses) rising.push_back(pose);
  std::string note;
  if (const size_t num_left = images.size() - rising.size()) {
    note = "# not here, but in " + stem + "_<drive>.txt: " + std::to_string(num_left) +
           " poses of other drives at the stamps of these\n";
  }
  return note + TrajectoryText(rising);
}

std::vector<NamedFile> TumFiles(const std::vector<PosedImage>& images, const std::string& stem) {
  std::vector<NamedFile> files = {{stem + ".txt", JointText(images, stem)}};
  const std::vector<DrivePoses> drives = PosesByDrive(images);
  for (const DrivePoses& drive : drives) {
    if (drives.size() == 1) continue;
    files.push_back({stem + "_" + drive.name + ".txt", TrajectoryText(drive.poses)});
  }
  return files;
}

// All drives from the first image of the map.
std::vector<NamedFile> KittiFiles(const LevelMap& map) {
  std::vector<NamedFile> files;
  const std::vector<DrivePoses> drives = PosesByDrive(PosedImages(map));
  for (const DrivePoses& drive : drives) {
    const StampedPose& first = drives.front().poses.front();
    const std::string stem = MainPathOf(MapFormat::kKitti) + "/" + drive.name;
    files.push_back({stem + "_poses.txt", KittiPosesText(drive.poses, first.reference_from_body)});
    files.push_back({stem + "_times.txt", KittiTimesText(drive.poses, first.stamp_ns)});
  }
  return files;
}

std::vector<NamedFile> FilesOf(const LevelMap& map, MapFormat format) {
  if (format == MapFormat::kTum) return TumFiles(PosedImages(map), kTrajectory);
  if (format == MapFormat::kKitti) return KittiFiles(map);
  if (format == MapFormat::kPly) return {{MainPathOf(format), MapCloudBytes(map)}};
  return {{MainPathOf(format), PlyText(LevelCloud(map), UnitOf(map))}};
}

constexpr char kGridPicture[] = "map.pgm";

// One map on its way into files; what is made of it is made once. Borrows all that it is given.
class MapInWork {
 public:
  MapInWork(const LevelMap& map, const MapSource& source, const MapFormats& formats)
      : map_(map),
        source_(source),
        formats_(formats),
        model_(source.model_of(map)),
        finished_(model_, source.pictures, source.features) {}
  MapInWork(const MapInWork&) = delete;
  MapInWork& operator=(const MapInWork&) = delete;

  const MapModel& model() const { return model_; }

  std::optional<DensifyCounts> densified() {
    if (formats_.count(MapFormat::kDensified) == 0) return std::nullopt;
    return finished_.Densified().counts;
  }

  std::vector<NamedFile> FilesOf(MapFormat format) {
    if (format == MapFormat::kGrid) return GridFiles();
    return {{MainPathOf(format), BytesOf(format)}};
  }

 private:
  std::string BytesOf(MapFormat format) {
    if (format == MapFormat::kDense) return DensePlyBytes(finished_.DenseCloud(), UnitOf(map_));
    if (format == MapFormat::kDensified) {
      return DensePlyBytes(finished_.Densified().cloud, UnitOf(map_));
    }
    if (format == MapFormat::kMesh) return MeshPlyBytes(finished_.Surface(), UnitOf(map_));
    return PageText(Page());
  }

  std::vector<NamedFile> GridFiles() {
    const bool has_dense = formats_.count(MapFormat::kDense) != 0;
    const OccupancyGridMap grid =
        MakeGrid(model_, has_dense ? &finished_.DenseCloud() : nullptr, {});
    return {{kGridPicture, GridPgm(grid)},
            {MainPathOf(MapFormat::kGrid), GridYaml(grid, kGridPicture)}};
  }

  // The page shows what is written beside it.
  std::string Page() {
    const bool has_mesh = formats_.count(MapFormat::kMesh) != 0;
    const bool has_dense = formats_.count(MapFormat::kDense) != 0;
    PageNotes notes = source_.notes;
    if (const auto counts = densified()) notes.figures = RowsOf(*counts);
    return PageDataJson(map_, model_, notes, has_dense ? &finished_.DenseCloud() : nullptr,
                        has_mesh ? &finished_.Surface() : nullptr);
  }

  const LevelMap& map_;
  const MapSource& source_;
  const MapFormats& formats_;
  const MapModel model_;
  FinishedMap finished_;
};

}  // namespace

fs::path FolderOfMap(const fs::path& folder, size_t rank) {
  return rank == 0 ? folder : folder / ("map_" + std::to_string(rank + 1));
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

std::string MapTrajectoryText(const LevelMap& map) {
  return JointText(PosedImages(map), kTrajectory);
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
  std::optional<MapInWork> work;
  for (const MapFormat format : formats) {
    if (format == MapFormat::kGrid && !map.scale) {
      all.left_out.push_back("grid: not written, as the map is not metric");
      continue;
    }
    const FormatSource made_from = SourceOf(format);
    if (made_from != FormatSource::kMap && !work) work.emplace(map, source, formats);
    WrittenFiles written =
        made_from == FormatSource::kFinished ? WriteFiles(work->FilesOf(format), folder, overwrite)
        : made_from == FormatSource::kModel
            ? WriteModelFiles(work->model(), format, source.pictures, folder, overwrite)
            : WriteFiles(FilesOf(map, format), folder, overwrite);
    all.paths.insert(all.paths.end(), written.paths.begin(), written.paths.end());
    all.pictures.insert(all.pictures.end(), written.pictures.begin(), written.pictures.end());
    all.missing_pictures.merge(written.missing_pictures);
  }
  if (work) all.densified = work->densified();
  return all;
}

void PrintWritten(const WrittenFiles& written, std::ostream& out) {
  for (const std::string& sentence : written.left_out) out << sentence << "\n";
  if (written.densified) out << Describe(*written.densified) << "\n";
  for (const fs::path& path : written.paths) out << "wrote " << path.string() << "\n";
  if (!written.missing_pictures.empty()) {
    out << CountWere(written.missing_pictures.size(), "picture")
        << " not at hand and not written with the rest\n";
  }
}

std::vector<NamedFile> LocalizedFiles(const MapSnapshot& snapshot,
                                      const std::map<FrameId, Localization>& localizations) {
  std::vector<NamedFile> files;
  size_t rank = 0;
  for (const LevelMap& map : FindMapsBySize(snapshot)) {
    const fs::path folder = FolderOfMap("", rank++);
    const std::vector<PosedImage> images = LocalizedImages(snapshot, map, localizations);
    if (images.empty() && rank > 1) continue;
    for (NamedFile& file : TumFiles(images, "localized")) {
      files.push_back({(folder / file.name).string(), std::move(file.content)});
    }
  }
  return files;
}

std::vector<fs::path> ListedMapFiles(const fs::path& folder) {
  static const std::regex kLocalized("(map_[0-9]+/)?localized(_[^/]+)?\\.txt");
  std::vector<fs::path> files = ListedFiles(folder);
  const auto is_localized = [&](const fs::path& file) {
    return std::regex_match(file.lexically_relative(fs::absolute(folder)).string(), kLocalized);
  };
  files.erase(std::remove_if(files.begin(), files.end(), is_localized), files.end());
  return files;
}

}  // namespace rovio_sfm
