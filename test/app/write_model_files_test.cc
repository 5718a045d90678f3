#include "rovio_sfm/app/write_model_files.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "io/synthetic_model.h"

namespace rovio_sfm {
namespace {

// A grey picture of the camera's size.
std::vector<uint8_t> GreyPicture() {
  std::vector<uint8_t> bytes;
  cv::imencode(".png", cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(90)), bytes);
  return bytes;
}

// Pictures of all images but the first.
PictureSource AllButFirst() {
  const auto grey = std::make_shared<const std::vector<uint8_t>>(GreyPicture());
  return [grey](const ModelImage& image) { return image.id.index == 0 ? nullptr : grey; };
}

TEST(WriteModelFiles, MakesAWorkspaceOfColmapWithThePicturesAsTheyCame) {
  const TemporaryFolder folder;
  const MapModel model = MakeSyntheticModel(FullCamera());
  const WrittenFiles written =
      WriteModelFiles(model, MapFormat::kColmap, AllButFirst(), folder.Path(), Overwrite::kRefuse);
  EXPECT_EQ(written.missing_pictures.size(), 1u);
  ASSERT_EQ(written.paths.size(), 5u);
  for (const auto& path : written.paths) {
    EXPECT_TRUE(path.is_absolute() && std::filesystem::exists(path)) << path;
  }
  const std::vector<uint8_t> grey = GreyPicture();
  EXPECT_EQ(ReadText(folder.Path() / "colmap/images/rovio/frame_1.jpg"),
            std::string(grey.begin(), grey.end()));
  const std::string printed =
      RunProgram("colmap model_analyzer --path " + (folder.Path() / "colmap/sparse/0").string());
  EXPECT_EQ(FigureAfter("Registered images:", printed), 8.0);
}

TEST(WriteModelFiles, GivesBundlerAndNvmUndistortedPictures) {
  for (const MapFormat format : {MapFormat::kBundler, MapFormat::kNvm}) {
    const TemporaryFolder folder;
    MapModel model = MakeSyntheticModel(FullCamera());
    model.images[6].name = "rovio/frame_6.png";
    const auto written =
        WriteModelFiles(model, format, AllButFirst(), folder.Path(), Overwrite::kRefuse);
    const auto pictures = folder.Path() / MainPathOf(format) / "images/rovio";
    for (const char* name : {"frame_6.png.jpg", "frame_7.jpg"}) {
      EXPECT_EQ(cv::imread(pictures / name).size(), cv::Size(640, 480)) << name;
      const auto tells = [&](const auto& path) {
        return !std::filesystem::is_directory(path) &&
               ReadText(path).find(name) != std::string::npos;
      };
      EXPECT_TRUE(std::any_of(written.paths.begin(), written.paths.end(), tells)) << name;
    }
    EXPECT_FALSE(std::filesystem::exists(pictures / "frame_0.jpg"));
  }
}

TEST(WriteModelFiles, NamesTheFrameWhosePictureIsSpoilt) {
  const TemporaryFolder folder;
  const MapModel model = MakeSyntheticModel(FullCamera());
  const auto spoilt = std::make_shared<const std::vector<uint8_t>>(3, uint8_t{1});
  const std::string error = MessageOf([&] {
    WriteModelFiles(
        model, MapFormat::kNvm, [&](const ModelImage&) { return spoilt; }, folder.Path(),
        Overwrite::kRefuse);
  });
  EXPECT_NE(error.find("rovio-5-6/0"), std::string::npos) << error;
}

TEST(WriteModelFiles, WritesTheSameBytesTwice) {
  const TemporaryFolder a, b;
  const MapModel model = MakeSyntheticModel(FullCamera());
  for (const MapFormat format :
       {MapFormat::kColmap, MapFormat::kColmapText, MapFormat::kBundler, MapFormat::kNvm}) {
    const auto first = WriteModelFiles(model, format, {}, a.Path(), Overwrite::kRefuse);
    const auto second = WriteModelFiles(model, format, {}, b.Path(), Overwrite::kRefuse);
    ASSERT_EQ(first.paths.size(), second.paths.size());
    for (size_t i = 0; i < first.paths.size(); ++i) {
      EXPECT_EQ(ReadText(first.paths[i]), ReadText(second.paths[i])) << first.paths[i];
    }
  }
}

}  // namespace
}  // namespace rovio_sfm
