#include "rovio_sfm/ros/export_folder.h"

#include <gtest/gtest.h>

#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

TEST(FindExportFolder, IsTheFolderItselfWithoutAName) {
  Status status;
  EXPECT_EQ(FindExportFolder("/maps", "", &status), std::filesystem::path("/maps/"));
  EXPECT_EQ(FindExportFolder("/maps", "friday", &status), std::filesystem::path("/maps/friday"));
}

TEST(FindExportFolder, RefusesWhereNoFolderIsSet) {
  Status status;
  EXPECT_FALSE(FindExportFolder("", "friday", &status));
  EXPECT_EQ(status.code, Status::FAILED_PRECONDITION);
}

TEST(FindExportFolder, RefusesNamesThatLeadElsewhere) {
  for (const char* name : {"../out", "/etc", "..", ".hidden", "a/b"}) {
    Status status;
    EXPECT_FALSE(FindExportFolder("/maps", name, &status)) << name;
    EXPECT_EQ(status.code, Status::INVALID_ARGUMENT) << name;
  }
}

TEST(FindExportFolder, RefusesAFileOfThatName) {
  const TemporaryFolder maps;
  maps.Write("a.db", "");
  Status status;
  EXPECT_FALSE(FindExportFolder(maps.Path().string(), "a.db", &status));
  EXPECT_EQ(status.code, Status::INVALID_ARGUMENT);
  EXPECT_NE(status.message.find("name = a.db: is a file"), std::string::npos) << status.message;
}

TEST(FindExportFolder, FollowsNoLinkOut) {
  const TemporaryFolder maps, outside;
  std::filesystem::create_directory_symlink(outside.Path(), maps.Path() / "out");
  Status status;
  EXPECT_FALSE(FindExportFolder(maps.Path().string(), "out", &status));
  EXPECT_EQ(status.code, Status::INVALID_ARGUMENT);
  EXPECT_NE(status.message.find("out is a link"), std::string::npos) << status.message;
}

}  // namespace
}  // namespace rovio_sfm
