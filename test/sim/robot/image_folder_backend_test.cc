#include "rovio_sfm/sim/robot/image_folder_backend.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace rovio_sfm::sim {
namespace {

class ImageFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("images_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_ / "images");
    for (const char* name : {"000001.jpg", "000000.jpg", "000002.txt"}) {
      std::ofstream(folder_ / "images" / name) << name;
    }
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  static std::string Next(ImageFolderBackend& robot) {
    const auto image = robot.Capture(5, {});
    return image ? std::string(image->jpeg.begin(), image->jpeg.end()) : "";
  }

  std::filesystem::path folder_;
  std::string error_;
};

TEST_F(ImageFolder, ShowsItsImagesInOrderThenNoMore) {
  const auto robot = ImageFolderBackend::Open(folder_.string(), false, &error_);
  ASSERT_NE(robot, nullptr) << error_;
  EXPECT_EQ(robot->num_images(), 2u);
  EXPECT_EQ(Next(*robot), "000000.jpg");
  EXPECT_EQ(Next(*robot), "000001.jpg");
  EXPECT_EQ(Next(*robot), "");
}

TEST_F(ImageFolder, BeginsAgainIfWanted) {
  const auto robot = ImageFolderBackend::Open((folder_ / "images").string(), true, &error_);
  ASSERT_NE(robot, nullptr) << error_;
  Next(*robot);
  Next(*robot);
  EXPECT_EQ(Next(*robot), "000000.jpg");
}

TEST_F(ImageFolder, RefusesAFolderWithoutImages) {
  EXPECT_EQ(ImageFolderBackend::Open("/nowhere", false, &error_), nullptr);
  EXPECT_EQ(error_, "no JPEG images in /nowhere");
}

TEST_F(ImageFolder, SwitchesAndHeadAreReportedBack) {
  const auto robot = ImageFolderBackend::Open(folder_.string(), false, &error_);
  robot->AdvanceTo(9);
  robot->MoveHead(HeadPosition::kUp);
  robot->SwitchHeadlight(true);
  robot->SwitchInfrared(true);
  EXPECT_EQ(robot->PeekMcu().head_position, 65);
  EXPECT_TRUE(robot->ReadMcu().headlight);
  EXPECT_TRUE(robot->ReadMcu().infrared);
  EXPECT_EQ(robot->ReadTruth().time_ns, 9);
}

}  // namespace
}  // namespace rovio_sfm::sim
