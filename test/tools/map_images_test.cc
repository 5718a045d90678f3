#include "rovio_sfm/tools/map_images.h"

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "rovio_sfm/io/text_file.h"
#include "tools/command_line.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

// A folder of grey images: nothing to see, nothing to map.
void WriteGreyFolder(const TemporaryFolder& folder) {
  folder.Write("drive/calibration.txt", "100 100 80 60 0 0 0 0 0 160 120\n");
  folder.Write("drive/times.txt", "0 images/a.png\n1 images/b.png\n");
  folder.Write("drive/images/a.png", "");
  const cv::Mat grey(120, 160, CV_8UC3, cv::Scalar::all(128));
  for (const char* name : {"a", "b"}) {
    cv::imwrite((folder.Path() / "drive/images" / (std::string(name) + ".png")).string(), grey);
  }
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

TEST(MapImagesCommand, RefusesBadArguments) {
  const TemporaryFolder folder;
  WriteGreyFolder(folder);
  const std::string drive = folder.Path() / "drive", out = folder.Path() / "out";
  std::string printed;
  EXPECT_NE(RunCommand(MapImagesCommand, {drive}, &printed), 0);
  EXPECT_NE(RunCommand(MapImagesCommand, {drive, "--out", out, "--mode", "some"}, &printed), 0);
  EXPECT_NE(RunCommand(MapImagesCommand, {drive, "--out", out, "--stride", "0"}, &printed), 0);
  EXPECT_THROW(RunCommand(MapImagesCommand, {drive, "--out", out, "--features", "1"}, &printed),
               std::runtime_error);
  EXPECT_THROW(RunCommand(MapImagesCommand, {"absent", "--out", out}, &printed),
               std::runtime_error);
}

}  // namespace
}  // namespace rovio_sfm
