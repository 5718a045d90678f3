#include "rovio_sfm/ros/export_map.h"

#include <gtest/gtest.h>
#include <rovio_sfm/Status.h>

#include <filesystem>
#include <future>
#include <iterator>
#include <vector>

#include "report/small_map.h"

namespace rovio_sfm {
namespace {

class ExportMapTest : public testing::Test {
 protected:
  ExportMapTest() {
    folder_ = std::filesystem::path(testing::TempDir()) / "export_map_test" /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(folder_);
  }

  ExportMapResponse Export(const std::string& name, bool overwrite = false, uint32_t map = 0) {
    ExportMapRequest request;
    request.name = name;
    request.overwrite = overwrite;
    request.map = map;
    return ExportMapFiles(*SmallMaps(1), {}, folder_.string(), request);
  }

  std::filesystem::path folder_;
};

TEST_F(ExportMapTest, WritesCloudAndTrajectoryAndTellsWhere) {
  const ExportMapResponse response = Export("first");
  ASSERT_EQ(response.status.code, Status::OK) << response.status.message;
  ASSERT_EQ(response.files.size(), 2u);
  for (const std::string& file : response.files) EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "first" / "cloud.ply"));
}

TEST_F(ExportMapTest, ReplacesNothingUnasked) {
  Export("");
  EXPECT_EQ(Export("").status.code, Status::ALREADY_EXISTS);
  EXPECT_EQ(Export("", true).status.code, Status::OK);
}

TEST_F(ExportMapTest, StaysBelowItsFolder) {
  for (const char* name : {"../out", "/etc", "..", ".hidden", "a/b"}) {
    EXPECT_EQ(Export(name).status.code, Status::INVALID_ARGUMENT) << name;
  }
}

TEST_F(ExportMapTest, RefusesAMapThatIsNotThereByNumber) {
  const ExportMapResponse response = Export("first", false, 99);
  EXPECT_EQ(response.status.code, Status::NOT_FOUND);
  EXPECT_EQ(response.status.message,
            "map = 99: expected the number of a map with a posed frame, or 0, the largest");
}

TEST_F(ExportMapTest, RefusesAFormatThatItDoesNotKnowByName) {
  ExportMapRequest request;
  request.formats = "tum,obj";
  const auto response = ExportMapFiles(*SmallMaps(1), {}, folder_.string(), request);
  EXPECT_EQ(response.status.code, Status::INVALID_ARGUMENT);
  EXPECT_EQ(response.status.message.find("formats = tum,obj: expected one or more of tum, "), 0u)
      << response.status.message;
  EXPECT_NE(response.status.message.find("\"obj\""), std::string::npos) << response.status.message;
  EXPECT_FALSE(std::filesystem::exists(folder_));
}

TEST_F(ExportMapTest, WritesTheFormatsAskedForAndSaysWhatIsMissing) {
  ExportMapRequest request;
  request.formats = "kitti,colmap,colmap_text";
  const MapSource source{[](const LevelMap&) {
                           MapModel model;
                           model.cameras.resize(1);
                           model.images.resize(2);
                           model.images[0].name = "a";
                           model.images[1].id.index = 1;
                           model.images[1].name = "b";
                           return model;
                         },
                         nullptr,
                         {}};
  const auto response = ExportMapFiles(*SmallMaps(1), source, folder_.string(), request);
  ASSERT_EQ(response.status.code, Status::OK) << response.status.message;
  EXPECT_NE(response.status.message.find("2 pictures were not at hand"), std::string::npos);
  EXPECT_EQ(response.files.size(), 10u);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "colmap/sparse/0/images.bin"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "cloud.ply"));
}

TEST_F(ExportMapTest, FailsWhereTheMapCannotBeWrittenInAnyOfTheFormats) {
  ExportMapRequest request;
  request.formats = "grid";
  const auto response = ExportMapFiles(*SmallMaps(1), {}, folder_.string(), request);
  EXPECT_EQ(response.status.code, Status::FAILED_PRECONDITION);
  EXPECT_EQ(response.status.message, "grid: not written, as the map is not metric");
}

TEST_F(ExportMapTest, FollowsNoLinkOutOfItsFolder) {
  const std::filesystem::path outside = folder_.string() + "_outside";
  std::filesystem::remove_all(outside);
  std::filesystem::create_directories(outside);
  std::filesystem::create_directories(folder_ / "real");
  std::filesystem::create_directory_symlink(outside, folder_ / "out");
  std::filesystem::create_directory_symlink(folder_ / "real", folder_ / "in");
  const ExportMapResponse response = Export("out");
  EXPECT_EQ(response.status.code, Status::INVALID_ARGUMENT);
  EXPECT_NE(response.status.message.find("out is a link"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_empty(outside));
  EXPECT_EQ(Export("in").status.code, Status::OK);
}

TEST_F(ExportMapTest, AnswersSeveralClientsAtOnce) {
  std::vector<std::future<int>> clients;
  for (int i = 0; i < 4; ++i) {
    clients.push_back(std::async(std::launch::async, [this] {
      int failed = 0;
      for (int k = 0; k < 20; ++k) failed += Export("same", true).status.code != Status::OK;
      return failed;
    }));
  }
  for (std::future<int>& client : clients) EXPECT_EQ(client.get(), 0);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / "same"), {}), 2);
}

TEST_F(ExportMapTest, UnknownMapIsNotFound) {
  EXPECT_EQ(Export("", false, 7).status.code, Status::NOT_FOUND);
}

TEST_F(ExportMapTest, WithoutAFolderNothingIsWritten) {
  const ExportMapResponse response = ExportMapFiles(*SmallMaps(1), {}, "", ExportMapRequest());
  EXPECT_EQ(response.status.code, Status::FAILED_PRECONDITION);
}

TEST_F(ExportMapTest, FolderThatCannotBeMadeIsAnError) {
  const ExportMapResponse response =
      ExportMapFiles(*SmallMaps(1), {}, "/proc/nowhere", ExportMapRequest());
  EXPECT_EQ(response.status.code, Status::INTERNAL);
  EXPECT_FALSE(response.status.message.empty());
}

}  // namespace
}  // namespace rovio_sfm
