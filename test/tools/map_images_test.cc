#include "rovio_sfm/tools/map_images.h"

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "frontend/moving_images.h"
#include "rovio_sfm/io/text_file.h"
#include "tools/command_line.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

// A drive of two images, a and b.
void WriteDrive(const TemporaryFolder& folder, const cv::Mat& a, const cv::Mat& b) {
  folder.Write("drive/calibration.txt", "100 100 80 60 0 0 0 0 0 160 120\n");
  folder.Write("drive/times.txt", "0 images/a.png\n1 images/b.png\n");
  folder.Write("drive/images/a.png", "");
  cv::imwrite((folder.Path() / "drive/images/a.png").string(), a);
  cv::imwrite((folder.Path() / "drive/images/b.png").string(), b);
}

// Grey images: nothing to see, nothing to map.
void WriteGreyFolder(const TemporaryFolder& folder) {
  const cv::Mat grey(120, 160, CV_8UC3, cv::Scalar::all(128));
  WriteDrive(folder, grey, grey);
}

// A wall of squares, each of a grey level of its own.
cv::Mat Squares(uint64_t seed) {
  cv::Mat levels(12, 16, CV_8UC1), image;
  cv::RNG(seed).fill(levels, cv::RNG::UNIFORM, 0, 256);
  cv::resize(levels, image, {160, 120}, 0, 0, cv::INTER_NEAREST);
  return image;
}

TEST(MapImagesCommand, WritesASummaryEvenWhereNothingCanBeMapped) {
  const TemporaryFolder folder;
  WriteGreyFolder(folder);
  const std::string out = folder.Path() / "out";
  std::string printed;
  ASSERT_EQ(RunCommand(MapImagesCommand, {folder.Path() / "drive", "--out", out}, &printed), 2);
  EXPECT_NE(printed.find("no image was registered"), std::string::npos) << printed;
  const auto bytes = ReadBytes(out + "/summary.json", 100000);
  const auto json = nlohmann::json::parse(bytes.begin(), bytes.end());
  EXPECT_EQ(json["frames"], 2);
  EXPECT_EQ(json["registered"], 0);
  EXPECT_THROW(RunCommand(MapImagesCommand, {folder.Path() / "drive", "--out", out}, &printed),
               std::runtime_error);
}

TEST(MapImagesCommand, SaysHowMuchTheImagesSharedWhereNoMapStarts) {
  const TemporaryFolder folder;
  WriteDrive(folder, Squares(1), Squares(2));
  const std::string out = folder.Path() / "out";
  std::string printed;
  ASSERT_EQ(RunCommand(MapImagesCommand, {folder.Path() / "drive", "--out", out}, &printed), 2);
  EXPECT_NE(printed.find("of 2 images 2 became keyframes; each shows "), std::string::npos)
      << printed;
  EXPECT_NE(printed.find(" features and shares 0 points with the one before it"), std::string::npos)
      << printed;
  EXPECT_NE(printed.find("two that share 100 "), std::string::npos) << printed;
}

// A few images of a walk past two walls, and as many again and more that show other things.
void WriteWalk(const TemporaryFolder& folder) {
  folder.Write("drive/calibration.txt", "256 256 160 120 0 0 0 0 0 320 240\n");
  folder.Write("drive/images/0.png", "");
  std::string times;
  for (int i = 0; i < 24; ++i) {
    const std::string name = "images/" + std::to_string(i) + ".png";
    const cv::Mat image = i < 10 ? MovingImages().At(12.0 * i) : Squares(static_cast<uint64_t>(i));
    cv::Mat resized;
    cv::resize(image, resized, {320, 240}, 0, 0, cv::INTER_NEAREST);
    cv::imwrite((folder.Path() / "drive" / name).string(), resized);
    times += std::to_string(i) + " " + name + "\n";
  }
  folder.Write("drive/times.txt", times);
}

TEST(MapImagesCommand, SaysHowMuchTheImagesSharedWhereMostHaveNoPose) {
  const TemporaryFolder folder;
  WriteWalk(folder);
  std::string printed;
  const std::string out = folder.Path() / "out";
  ASSERT_EQ(RunCommand(MapImagesCommand, {folder.Path() / "drive", "--out", out}, &printed), 0);
  EXPECT_NE(printed.find("14 of 24 images have no pose: each shows "), std::string::npos)
      << printed;
}

TEST(MapImagesCommand, TellsWhichFormatsAMapCannotBeWrittenIn) {
  const TemporaryFolder folder;
  WriteWalk(folder);
  std::string printed;
  const std::string drive = folder.Path() / "drive", out = folder.Path() / "out";
  ASSERT_EQ(RunCommand(MapImagesCommand, {drive, "--out", out, "--format", "grid"}, &printed), 1);
  EXPECT_NE(printed.find("grid: not written, as the map is not metric\n"), std::string::npos)
      << printed;
  const auto bytes = ReadBytes(out + "/summary.json", 100000);
  const auto json = nlohmann::json::parse(bytes.begin(), bytes.end());
  EXPECT_EQ(json["formats_left_out"][0], "map 1: grid: not written, as the map is not metric");
  ASSERT_EQ(RunCommand(MapImagesCommand,
                       {drive, "--out", out, "--format", "grid,tum", "--overwrite"}, &printed),
            0);
  EXPECT_NE(printed.find("grid: not written"), std::string::npos) << printed;
}

TEST(MapImagesCommand, MakesNoFolderForWhatItRefuses) {
  const TemporaryFolder folder;
  WriteGreyFolder(folder);
  const std::string drive = folder.Path() / "drive", out = folder.Path() / "out";
  std::string printed;
  const auto complaint = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {drive, "--out", out});
    return MessageOf([&] { RunCommand(MapImagesCommand, more, &printed); });
  };
  EXPECT_EQ(complaint({"--localize"}),
            out + "/map.db: no such file; --localize expected the maps of an earlier run");
  EXPECT_NE(complaint({"--localize", "--no-store"}).find("--no-store"), std::string::npos);
  EXPECT_NE(complaint({"--places", "/nowhere"}).find("/nowhere"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(MapImagesCommand, RefusesBadArguments) {
  const TemporaryFolder folder;
  WriteGreyFolder(folder);
  const std::string drive = folder.Path() / "drive", out = folder.Path() / "out";
  std::string printed;
  EXPECT_THROW(RunCommand(MapImagesCommand, {drive}, &printed), std::runtime_error);
  EXPECT_THROW(RunCommand(MapImagesCommand, {drive, "--out", out, "--mode", "some"}, &printed),
               std::runtime_error);
  EXPECT_THROW(RunCommand(MapImagesCommand, {drive, "--out", out, "--stride", "0"}, &printed),
               std::runtime_error);
  EXPECT_THROW(RunCommand(MapImagesCommand, {drive, "--out", out, "--features", "1"}, &printed),
               std::runtime_error);
  EXPECT_THROW(RunCommand(MapImagesCommand, {"absent", "--out", out}, &printed),
               std::runtime_error);
}

}  // namespace
}  // namespace rovio_sfm
