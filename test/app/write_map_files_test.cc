#include "rovio_sfm/app/write_map_files.h"

#include "report/small_snapshot.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

LevelMap SmallMap(uint32_t num_sessions) {
  MapSnapshot snapshot;
  for (uint32_t i = 1; i <= num_sessions; ++i) {
    snapshot.sessions.push_back(SmallSession(i, 4, {SmallLandmark(1, 4, 0.001)}));
    snapshot.sessions.back().map = {1};
    snapshot.sessions.back().drive.robot = "robot" + std::to_string(i);
  }
  return *FindLargestMap(snapshot);
}

TEST(WriteMapFiles, WritesPathAndCloudAndReplacesNothing) {
  const TemporaryFolder folder;
  const auto written = WriteMapFiles(SmallMap(1), folder.Path(), Overwrite::kRefuse);
  ASSERT_EQ(written.size(), 2u);
  EXPECT_TRUE(written[0].is_absolute());
  EXPECT_EQ(ReadTrajectory(folder.Path() / "trajectory.txt").size(), 3u);
  EXPECT_TRUE(std::filesystem::exists(folder.Path() / "cloud.ply"));
  EXPECT_THROW(WriteMapFiles(SmallMap(1), folder.Path(), Overwrite::kRefuse), std::runtime_error);
}

TEST(WriteMapFiles, WritesEachOfSeveralDrivesByItself) {
  const TemporaryFolder folder;
  EXPECT_EQ(WriteMapFiles(SmallMap(2), folder.Path(), Overwrite::kRefuse).size(), 4u);
  EXPECT_EQ(ReadTrajectory(folder.Path() / "trajectory_robot2.txt").size(), 3u);
}

TEST(MapTrajectoryText, HoldsEachStampOnce) {
  const TemporaryFolder folder;
  folder.Write("all.txt", MapTrajectoryText(SmallMap(2)));  // both have the same three stamps
  EXPECT_EQ(ReadTrajectory(folder.Path() / "all.txt").size(), 3u);
}

TEST(WriteMapFiles, WritesEachOfARobotsDrivesByItself) {
  const TemporaryFolder folder;
  LevelMap map = SmallMap(3);
  map.sessions[1].drive = {"robot1", map.sessions[0].drive.start_ns, 7};  // nonce alone differs
  EXPECT_EQ(WriteMapFiles(map, folder.Path(), Overwrite::kRefuse).size(), 5u);
  for (const SessionSnapshot& session : {map.sessions[0], map.sessions[1]}) {
    const std::string name = "trajectory_" + session.drive.ToString() + ".txt";
    EXPECT_EQ(ReadTrajectory(folder.Path() / name).size(), 3u) << name;
  }
  EXPECT_TRUE(std::filesystem::exists(folder.Path() / "trajectory_robot3.txt"));
}

TEST(MapCloudBytes, SaysItsUnit) {
  LevelMap map = SmallMap(1);
  EXPECT_NE(MapCloudBytes(map).find("map units"), std::string::npos);
  map.scale = MapScale{1.0, 0.01, "odometry"};
  EXPECT_NE(MapCloudBytes(map).find("metres"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
