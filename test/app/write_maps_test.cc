#include "rovio_sfm/app/write_maps.h"

#include "report/small_snapshot.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

// Two maps: the second has two sessions.
MapSnapshot TwoMaps() {
  MapSnapshot snapshot;
  for (uint32_t i = 1; i <= 3; ++i) {
    snapshot.sessions.push_back(SmallSession(i, 4, {SmallLandmark(1, 4, 0.001)}));
    snapshot.sessions.back().map = {i == 1 ? 1u : 2u};
    snapshot.sessions.back().drive.robot = "robot" + std::to_string(i);
  }
  return snapshot;
}

TEST(WriteAllMaps, WritesTheLargestIntoTheFolderAndTheOthersBelow) {
  const TemporaryFolder folder;
  const auto maps = WriteAllMaps(TwoMaps(), folder.Path() / "out", Overwrite::kRefuse);
  ASSERT_EQ(maps.size(), 2u);
  EXPECT_EQ(maps[0].id, MapId{2});
  EXPECT_EQ(maps[0].num_images, 6u);
  EXPECT_TRUE(std::filesystem::exists(folder.Path() / "out/trajectory_robot3.txt"));
  EXPECT_EQ(maps[1].id, MapId{1});
  EXPECT_TRUE(std::filesystem::exists(folder.Path() / "out/map_2/cloud.ply"));
  EXPECT_EQ(Describe(maps[1]), "map 1: 3 images, in map units, in " +
                                   std::filesystem::absolute(folder.Path() / "out/map_2").string());
  EXPECT_EQ(FindMapFiles(folder.Path() / "out").size(), 6u);
}

TEST(WriteAllMaps, RemovesWhatAnEarlierRunLeftAndNothingElse) {
  const TemporaryFolder folder;
  WriteAllMaps(TwoMaps(), folder.Path(), Overwrite::kRefuse);
  const std::vector<std::string> mine = {"notes.txt", "trajectory_true.txt", "map.png",
                                         "map_9/trajectory_of_colmap.txt", "map_2/cloud_mine.ply"};
  std::filesystem::create_directories(folder.Path() / "map_9");
  for (const std::string& name : mine) folder.Write(name, "mine");
  MapSnapshot one = TwoMaps();
  one.sessions.resize(1);
  EXPECT_THROW(WriteAllMaps(one, folder.Path(), Overwrite::kRefuse), std::runtime_error);
  EXPECT_EQ(FindMapFiles(folder.Path()).size(), 6u);
  WriteAllMaps(one, folder.Path(), Overwrite::kAllow);
  EXPECT_EQ(FindMapFiles(folder.Path()).size(), 2u);
  EXPECT_FALSE(std::filesystem::exists(folder.Path() / "map_2/cloud.ply"));
  for (const std::string& name : mine) {
    EXPECT_TRUE(std::filesystem::exists(folder.Path() / name)) << name;
  }
}

TEST(WriteAllMaps, RemovesProductsOfAnotherMapInEveryFormat) {
  const TemporaryFolder folder;
  MapSource source;
  source.model_of = [](const LevelMap&) { return MapModel(); };
  const MapFormats formats = {MapFormat::kTum, MapFormat::kKitti, MapFormat::kNvm};
  WriteAllMaps(TwoMaps(), source, formats, folder.Path(), Overwrite::kRefuse);
  EXPECT_TRUE(std::filesystem::exists(folder.Path() / "kitti/robot3_poses.txt"));
  EXPECT_TRUE(std::filesystem::exists(folder.Path() / "map_2/nvm/model.nvm"));
  MapSnapshot one = TwoMaps();
  one.sessions.resize(1);
  WriteAllMaps(one, folder.Path(), Overwrite::kAllow);
  for (const char* gone : {"kitti", "nvm", "map_2", "trajectory_robot3.txt"}) {
    EXPECT_FALSE(std::filesystem::exists(folder.Path() / gone)) << gone;
  }
  EXPECT_EQ(FindMapFiles(folder.Path()).size(), 2u);
}

TEST(WriteAllMaps, TellsOfAMapThatNoFormatCouldHold) {
  const TemporaryFolder folder;
  const auto maps =
      WriteAllMaps(TwoMaps(), {}, {MapFormat::kGrid}, folder.Path() / "out", Overwrite::kRefuse);
  ASSERT_EQ(maps.size(), 2u);
  EXPECT_TRUE(maps[0].files.empty());
  EXPECT_EQ(maps[0].left_out.size(), 1u);
  EXPECT_EQ(Describe(maps[0]), "map 2: 6 images, in map units, in " +
                                   std::filesystem::absolute(folder.Path() / "out").string());
  EXPECT_FALSE(std::filesystem::exists(folder.Path() / "out/map_2"));
}

TEST(FindMapFiles, FindsNothingWhereThereIsNoFolder) {
  EXPECT_TRUE(FindMapFiles("/nowhere/at/all").empty());
}

}  // namespace
}  // namespace rovio_sfm
