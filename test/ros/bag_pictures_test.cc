#include "rovio_sfm/ros/bag_pictures.h"

#include <opencv2/imgcodecs.hpp>

#include "rovio_sfm/ros/images_to_bag.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kStartNs = 1600000000000000000;

// A bag of three grey pictures, a second apart, from so many seconds after the start; that much
// brighter.
std::filesystem::path WriteGreyBag(const TemporaryFolder& folder, const std::string& robot,
                                   int start_s, int brighter = 0) {
  DatasetFolder dataset;
  dataset.path = folder.Path();
  dataset.camera = {500.0, 510.0, 32.0, 24.0, 0.01, 0, 0, 0, 0, 64, 48};
  for (int i = start_s; i < start_s + 3; ++i) {
    DatasetImage image;
    image.name = std::to_string(i) + ".png";
    image.path = folder.Path() / image.name;
    image.stamp_ns = kStartNs + i * 1'000'000'000LL;
    cv::imwrite(image.path.string(), cv::Mat(48, 64, CV_8UC1, cv::Scalar(10 * i + brighter)));
    dataset.images.push_back(image);
  }
  const std::filesystem::path bag =
      folder.Path() / (robot + std::to_string(start_s + brighter) + ".bag");
  WriteBag(dataset, robot, bag, true);
  return bag;
}

// The grey level of the drive's picture so many seconds after the start; -1: none.
int GreyAt(size_t drive, int at_s, BagPictures* pictures) {
  const ImageBytes bytes = pictures->Find(drive, kStartNs + at_s * 1'000'000'000LL);
  return bytes == nullptr ? -1 : cv::imdecode(*bytes, cv::IMREAD_GRAYSCALE).at<uint8_t>(0, 0);
}

TEST(BagPictures, FindsPicturesOfAllBagsInAnyOrder) {
  const TemporaryFolder folder;
  BagPictures pictures(
      FindDrives({WriteGreyBag(folder, "rovio1", 0), WriteGreyBag(folder, "rovio2", 10),
                  WriteGreyBag(folder, "rovio1", 20)}),
      SensorOptions());
  for (const int at_s : {0, 2, 20, 22, 1, 0}) {
    EXPECT_EQ(GreyAt(at_s < 10 ? 0 : 2, at_s, &pictures), 10 * at_s) << at_s;
  }
  EXPECT_EQ(GreyAt(1, 11, &pictures), 110);
  EXPECT_EQ(GreyAt(2, 21, &pictures), 210);
}

TEST(BagPictures, TellsBagsOfTheSameRobotAndTimeApart) {
  const TemporaryFolder folder;
  BagPictures pictures(
      FindDrives({WriteGreyBag(folder, "rovio1", 0), WriteGreyBag(folder, "rovio1", 0, 50)}),
      SensorOptions());
  EXPECT_EQ(GreyAt(0, 1, &pictures), 10);
  EXPECT_EQ(GreyAt(1, 1, &pictures), 60);
}

TEST(BagPictures, FindsNothingWhereNoneIs) {
  const TemporaryFolder folder;
  BagPictures pictures(FindDrives({WriteGreyBag(folder, "rovio1", 0)}), SensorOptions());
  EXPECT_EQ(GreyAt(0, 7, &pictures), -1);
  EXPECT_EQ(GreyAt(0, 1, &pictures), 10);
}

}  // namespace
}  // namespace rovio_sfm
