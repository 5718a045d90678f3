#include "rovio_sfm/app/write_map_files.h"

#include <algorithm>
#include <map>

#include "rovio_sfm/report/level_session.h"

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
  std::vector<StampedPose> poses;
  for (const PosedImage& image : PosedImages(map)) poses.push_back(image.level_from_camera);
  return TrajectoryText(poses);
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
