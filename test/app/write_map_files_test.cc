#include "rovio_sfm/app/write_map_files.h"

#include "io/synthetic_model.h"
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

std::vector<std::filesystem::path> WriteDefault(const LevelMap& map, const TemporaryFolder& folder,
                                                const std::string& formats = "") {
  return WriteMapFiles(map, {}, ReadFormats(formats), folder.Path(), Overwrite::kRefuse).paths;
}

TEST(WriteMapFiles, WritesPathAndCloudAndReplacesNothing) {
  const TemporaryFolder folder;
  const auto written = WriteDefault(SmallMap(1), folder);
  ASSERT_EQ(written.size(), 2u);
  EXPECT_TRUE(written[0].is_absolute());
  EXPECT_EQ(ReadTrajectory(folder.Path() / "trajectory.txt").size(), 3u);
  EXPECT_TRUE(std::filesystem::exists(folder.Path() / "cloud.ply"));
  EXPECT_THROW(WriteDefault(SmallMap(1), folder), std::runtime_error);
}

TEST(WriteMapFiles, WritesEachOfSeveralDrivesByItself) {
  const TemporaryFolder folder;
  EXPECT_EQ(WriteDefault(SmallMap(2), folder).size(), 4u);
  EXPECT_EQ(ReadTrajectory(folder.Path() / "trajectory_robot2.txt").size(), 3u);
}

// Poses of different frames and units, at stamps that several drives have, are never in one file.
TEST(LocalizedFiles, AreOneForEachMapAndDrive) {
  MapSnapshot snapshot;
  snapshot.sessions = {SmallSession(1, 5, {}), SmallSession(2, 4, {}), SmallSession(3, 3, {})};
  std::map<FrameId, Localization> localizations;
  const auto add = [&](const std::string& robot, uint32_t index, uint32_t session) {
    const FrameId id{{robot, 1, 9}, index};
    localizations[id].stamp_ns = 1'000'000'000 * static_cast<int64_t>(index);
    localizations[id].session = {session};
  };
  for (uint32_t i = 1; i <= 3; ++i) add("a", i, 1);
  for (uint32_t i = 3; i <= 4; ++i) add("b", i, 1);
  add("b", 5, 3);
  const TemporaryFolder folder;
  const auto files = LocalizedFiles(snapshot, localizations);
  const auto paths = WriteFiles(files, folder.Path(), Overwrite::kRefuse).paths;
  const std::vector<std::pair<std::string, size_t>> expected = {{"localized.txt", 4},
                                                                {"localized_a.txt", 3},
                                                                {"localized_b.txt", 2},
                                                                {"map_3/localized.txt", 1}};
  ASSERT_EQ(paths.size(), expected.size());
  for (size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(files[i].name, expected[i].first);
    EXPECT_EQ(ReadTrajectory(paths[i]).size(), expected[i].second) << files[i].name;
  }
}

TEST(LocalizedFiles, OfNothingFoundAreOneWithoutPoses) {
  MapSnapshot snapshot;
  snapshot.sessions = {SmallSession(1, 5, {})};
  const auto files = LocalizedFiles(snapshot, {});
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0].name, "localized.txt");
}

TEST(MapTrajectoryText, HoldsEachStampOnce) {
  const TemporaryFolder folder;
  folder.Write("all.txt", MapTrajectoryText(SmallMap(2)));  // both have the same three stamps
  EXPECT_EQ(ReadTrajectory(folder.Path() / "all.txt").size(), 3u);
  EXPECT_NE(MapTrajectoryText(SmallMap(2)).find("3 poses of other drives"), std::string::npos);
  EXPECT_EQ(MapTrajectoryText(SmallMap(1)).find("other drives"), std::string::npos);
}

TEST(WriteMapFiles, WritesEachOfARobotsDrivesByItself) {
  const TemporaryFolder folder;
  LevelMap map = SmallMap(3);
  map.sessions[1].drive = {"robot1", map.sessions[0].drive.start_ns, 7};  // nonce alone differs
  EXPECT_EQ(WriteDefault(map, folder).size(), 5u);
  for (const SessionSnapshot& session : {map.sessions[0], map.sessions[1]}) {
    const std::string name = "trajectory_" + session.drive.ToString() + ".txt";
    EXPECT_EQ(ReadTrajectory(folder.Path() / name).size(), 3u) << name;
  }
  EXPECT_TRUE(std::filesystem::exists(folder.Path() / "trajectory_robot3.txt"));
}

TEST(WriteMapFiles, WritesNothingWhereOneFormatIsThereAlready) {
  const TemporaryFolder folder;
  folder.Write("kitti/other.txt", "");
  const std::string error = MessageOf([&] { WriteDefault(SmallMap(1), folder, "ply,kitti"); });
  EXPECT_NE(error.find((folder.Path() / "kitti").string()), std::string::npos) << error;
  EXPECT_FALSE(std::filesystem::exists(folder.Path() / "cloud.ply"));
  WriteMapFiles(SmallMap(1), {}, ReadFormats("ply,kitti"), folder.Path(), Overwrite::kAllow);
  EXPECT_TRUE(std::filesystem::exists(folder.Path() / "cloud.ply"));
}

// Every drive of the map from its first image.
TEST(WriteMapFiles, WritesKittiPosesOfEachDrive) {
  const TemporaryFolder folder;
  EXPECT_EQ(WriteDefault(SmallMap(2), folder, "kitti").size(), 4u);
  const std::string first = ReadText(folder.Path() / "kitti/robot1_poses.txt");
  std::istringstream numbers(first);
  std::vector<double> values;
  for (double value = 0.0; numbers >> value;) values.push_back(value);
  ASSERT_EQ(values.size(), 3u * 12u);
  for (const size_t i : {0u, 5u, 10u}) EXPECT_NEAR(values[i], 1.0, 1e-12);
  EXPECT_NEAR(values[12 + 3], 0.5, 1e-12);  // the camera moves to its right
  EXPECT_EQ(ReadText(folder.Path() / "kitti/robot1_times.txt"), "0.000000\n0.100000\n0.200000\n");
  EXPECT_EQ(ReadText(folder.Path() / "kitti/robot2_poses.txt"), first);
}

TEST(WriteMapFiles, AsksForTheModelOnlyWhereAFormatNeedsIt) {
  const TemporaryFolder folder;
  int num_asked = 0;
  const MapSource source{[&](const LevelMap&) {
                           ++num_asked;
                           return MapModel();
                         },
                         nullptr,
                         {}};
  const auto write = [&](const std::string& formats) {
    WriteMapFiles(SmallMap(1), source, ReadFormats(formats), folder.Path(), Overwrite::kAllow);
  };
  write("ply_ascii,tum,kitti");
  EXPECT_EQ(num_asked, 0);
  write("colmap,nvm,bundler");
  EXPECT_EQ(num_asked, 1);
}

TEST(WriteMapFiles, CountsAPictureOnceHoweverManyFormatsMissIt) {
  const TemporaryFolder folder;
  const MapModel model = MakeSyntheticModel(FullCamera());
  const MapSource source{[&](const LevelMap&) { return model; }, nullptr, {}};
  const WrittenFiles written =
      WriteMapFiles(SmallMap(1), source, ReadFormats("colmap,colmap_text,nvm,bundler"),
                    folder.Path(), Overwrite::kRefuse);
  EXPECT_EQ(written.missing_pictures.size(), model.images.size());
}

TEST(PrintWritten, SaysWhatIsMissing) {
  std::ostringstream out;
  const DriveId drive{"robot", 0, 0};
  PrintWritten({{"/a/b"}, {{drive, 0}, {drive, 1}, {drive, 4}}, {}}, out);
  EXPECT_EQ(out.str(), "wrote /a/b\n3 pictures were not at hand and not written with the rest\n");
}

TEST(PrintWritten, SaysWhatDensifyingBrought) {
  WrittenFiles written;
  written.densified.emplace().after.num_points = 7;
  std::ostringstream out;
  PrintWritten(written, out);
  EXPECT_NE(out.str().find("densified: 0 -> 7 points"), std::string::npos) << out.str();
}

TEST(WriteMapFiles, CountsWhatIsDensified) {
  const TemporaryFolder folder;
  MapSource source;
  source.model_of = [](const LevelMap&) { return MapModel(); };
  const auto write = [&](const std::string& formats) {
    return WriteMapFiles(SmallMap(1), source, ReadFormats(formats), folder.Path(),
                         Overwrite::kAllow);
  };
  const WrittenFiles written = write("densified");
  EXPECT_TRUE(written.densified);
  ASSERT_EQ(written.paths.size(), 1u);
  EXPECT_EQ(written.paths[0].filename(), "densified.ply");
  EXPECT_FALSE(write("colmap").densified);
}

TEST(MapCloudBytes, SaysItsUnit) {
  LevelMap map = SmallMap(1);
  EXPECT_NE(MapCloudBytes(map).find("map units"), std::string::npos);
  map.scale = MapScale{1.0, 0.01, "odometry"};
  EXPECT_NE(MapCloudBytes(map).find("metres"), std::string::npos);
}

TEST(WriteMapFiles, LeavesOutAGridOfAMapThatIsNotMetric) {
  const TemporaryFolder folder;
  const WrittenFiles written =
      WriteMapFiles(SmallMap(1), {}, ReadFormats("tum,grid"), folder.Path(), Overwrite::kRefuse);
  EXPECT_EQ(written.paths.size(), 1u);
  ASSERT_EQ(written.left_out.size(), 1u);
  EXPECT_NE(written.left_out[0].find("grid"), std::string::npos);
}

TEST(WriteMapFiles, WritesGridAndReportOfAModel) {
  const TemporaryFolder folder;
  LevelMap map = SmallMap(1);
  map.scale = MapScale{1.0, 0.05, "odometry"};
  MapSource source;
  source.model_of = [](const LevelMap&) {
    MapModel model;
    model.length_unit = "metres";
    model.cameras.resize(1);
    model.images.resize(1);
    return model;
  };
  const WrittenFiles written =
      WriteMapFiles(map, source, ReadFormats("grid,report"), folder.Path(), Overwrite::kRefuse);
  EXPECT_EQ(written.paths.size(), 3u);
  for (const char* name : {"map.yaml", "map.pgm", "report.html"}) {
    EXPECT_TRUE(std::filesystem::exists(folder.Path() / name)) << name;
  }
}

}  // namespace
}  // namespace rovio_sfm
