#include "rovio_sfm/app/write_map_files.h"

#include <algorithm>
#include <map>

namespace rovio_sfm {
namespace {

std::map<DriveId, std::vector<StampedPose>> PosesByDrive(const LevelMap& map) {
  std::map<DriveId, std::vector<StampedPose>> poses;
  for (const PosedImage& image : PosedImages(map)) {
    poses[image.id.drive].push_back(image.level_from_camera);
  }
  return poses;
}

// The robot, and where it has several drives in the map all that tells them apart.
std::string NameOf(const DriveId& drive, const std::map<DriveId, std::vector<StampedPose>>& poses) {
  const auto num_drives = std::count_if(poses.begin(), poses.end(), [&](const auto& other) {
    return other.first.robot == drive.robot;
  });
  return num_drives > 1 ? drive.ToString() : drive.robot;
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

std::string MapCloudBytes(const LevelMap& map) {
  return PlyBytes(LevelCloud(map), map.scale ? "metres" : "map units");
}

std::vector<std::filesystem::path> WriteMapFiles(const LevelMap& map,
                                                 const std::filesystem::path& folder,
                                                 Overwrite overwrite) {
  std::vector<std::filesystem::path> written;
  const auto write = [&](const std::string& name, const std::string& content) {
    WriteFile(folder / name, content, overwrite);
    written.push_back(std::filesystem::absolute(folder / name));
  };
  write("trajectory.txt", MapTrajectoryText(map));
  const auto poses = PosesByDrive(map);
  for (const auto& [drive, drive_poses] : poses) {
    if (poses.size() == 1) continue;
    write("trajectory_" + NameOf(drive, poses) + ".txt", TrajectoryText(drive_poses));
  }
  write("cloud.ply", MapCloudBytes(map));
  return written;
}

}  // namespace rovio_sfm
