#include "rovio_sfm/app/output_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

namespace rovio_sfm {
namespace {

const OutputPlace kPlace = {"/people/robin", "", "2026-01-02_03-04-05"};

TEST(NodeOutputFolder, IsADatedOneOfRosHomeWithoutAValue) {
  EXPECT_EQ(NodeOutputFolder("output_dir", "", kPlace),
            "/people/robin/.ros/rovio_sfm/2026-01-02_03-04-05");
  OutputPlace place = kPlace;
  place.ros_home = "/var/ros";
  EXPECT_EQ(NodeOutputFolder("output_dir", "", place), "/var/ros/rovio_sfm/2026-01-02_03-04-05");
}

TEST(NodeOutputFolder, IsNeverOneThatIsThere) {
  OutputPlace place = kPlace;
  place.ros_home = testing::TempDir() + "/ros_home";
  const std::filesystem::path first = NodeOutputFolder("output_dir", "", place);
  std::filesystem::create_directories(first);
  EXPECT_EQ(NodeOutputFolder("output_dir", "", place), first.string() + "_2");
  std::filesystem::remove_all(place.ros_home);
}

TEST(NodeOutputFolder, ExpandsTheTildeAndRefusesRelativePaths) {
  EXPECT_EQ(NodeOutputFolder("output_dir", "~/maps", kPlace), "/people/robin/maps");
  EXPECT_EQ(NodeOutputFolder("output_dir", "~", kPlace), "/people/robin");
  EXPECT_EQ(NodeOutputFolder("output_dir", "/maps", kPlace), "/maps");
  for (const char* value : {"maps", "./maps", "~robin/maps"}) {
    try {
      NodeOutputFolder("output_dir", value, kPlace);
      ADD_FAILURE() << value;
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()).rfind("output_dir: '" + std::string(value) + "'", 0), 0u);
    }
  }
}

TEST(RequireWritableFolder, MakesItAndLeavesNothing) {
  const std::filesystem::path folder = testing::TempDir() + "/writable/deep";
  std::filesystem::remove_all(folder.parent_path());
  RequireWritableFolder(folder, 1);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  std::filesystem::remove_all(folder.parent_path());
}

TEST(RequireWritableFolder, NamesTheFolderAndWhyItCannotBeWritten) {
  try {
    RequireWritableFolder("/proc", 1);
    ADD_FAILURE() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()), "/proc: cannot be written: No such file or directory");
  }
}

TEST(RequireWritableFolder, RefusesAFileAndTooLittleRoom) {
  const std::filesystem::path file = testing::TempDir() + "/a_file";
  std::ofstream(file) << "x";
  EXPECT_THROW(RequireWritableFolder(file / "below", 1), std::runtime_error);
  std::filesystem::remove(file);
  EXPECT_THROW(RequireWritableFolder(testing::TempDir(), uintmax_t{1} << 62), std::runtime_error);
}

}  // namespace
}  // namespace rovio_sfm
