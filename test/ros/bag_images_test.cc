#include "rovio_sfm/ros/bag_images.h"

#include <gtest/gtest.h>
#include <tf2_msgs/TFMessage.h>

#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/images_to_bag.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kStartNs = 1600000000000000000;
constexpr int64_t kStepNs = 100000000;

// A data set of three grey images with odometry and a head that moves.
class BagImagesTest : public testing::Test {
 protected:
  BagImagesTest() {
    folder_ = std::filesystem::path(testing::TempDir()) /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ / "images");
    dataset_.path = folder_;
    dataset_.camera = {500.0, 510.0, 32.0, 24.0, 0.01, 0, 0, 0, 0, 64, 48};
    std::ofstream odometry(folder_ / "odometry.txt");
    for (int i = 0; i < 3; ++i) {
      AddImage(i);
      const double x_m = 0.1 * i;
      odometry << 1600000000 << "." << i << "0 " << x_m << " 0 0 1 0 0 0 1 0 0 0 1\n";
    }
  }

  void AddImage(int i) {
    DatasetImage image;
    image.name = std::to_string(i) + ".png";
    image.path = folder_ / "images" / image.name;
    image.stamp_ns = kStartNs + i * kStepNs;
    image.base_from_camera = Rigid3{Eigen::Quaterniond::Identity(), {0.0, 0.0, 0.1 + i}};
    cv::imwrite(image.path.string(), cv::Mat(48, 64, CV_8UC1, cv::Scalar(50 * i)));
    dataset_.images.push_back(image);
  }

  std::filesystem::path Write(const std::string& robot = "rovio7") {
    const std::filesystem::path bag = folder_ / "drive.bag";
    WriteBag(dataset_, robot, bag, true);
    return bag;
  }

  std::filesystem::path folder_;
  DatasetFolder dataset_;
};

TEST_F(BagImagesTest, GivesBackWhatImagesToBagWrote) {
  const std::vector<BagDrive> drives = FindDrives({Write()});
  ASSERT_EQ(drives.size(), 1u);
  EXPECT_EQ(drives[0].robot, "rovio7");
  BagImages images(drives[0], SensorOptions());
  EXPECT_EQ(images.Count(), 3u);
  for (int i = 0; i < 3; ++i) {
    const auto event = images.Next();
    ASSERT_TRUE(event);
    EXPECT_EQ(event->stamp_ns, kStartNs + i * kStepNs);
    EXPECT_EQ(event->name, "00000" + std::to_string(i));
    EXPECT_EQ(event->camera, dataset_.camera);
    EXPECT_EQ(event->encoded->size(),
              std::filesystem::file_size(dataset_.images[static_cast<size_t>(i)].path));
    ASSERT_TRUE(event->odometry);
    EXPECT_NEAR(event->odometry->x_m, 0.1 * i, 1e-9);
    ASSERT_TRUE(event->base_from_camera);
    EXPECT_NEAR(event->base_from_camera->translation.z(), 0.1 + i, 1e-9);
  }
  EXPECT_FALSE(images.Next());
  EXPECT_EQ(images.NumRefused(), 0u);
}

TEST_F(BagImagesTest, ImageLatencyAsksForEarlierOdometry) {
  SensorOptions options;
  options.image_latency_s = 0.05;
  BagImages images(FindDrives({Write()})[0], options);
  const auto first = images.Next();
  const auto second = images.Next();
  ASSERT_TRUE(first && second && second->odometry);
  EXPECT_FALSE(first->odometry);
  EXPECT_NEAR(second->odometry->x_m, 0.05, 1e-9);
}

TEST_F(BagImagesTest, MissingBagIsNamed) {
  try {
    FindDrives({folder_ / "none.bag"});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("none.bag"), std::string::npos);
  }
}

TEST_F(BagImagesTest, SetsThatBeginAtZeroBecomeBags) {
  for (DatasetImage& image : dataset_.images) image.stamp_ns -= kStartNs;
  std::filesystem::remove(folder_ / "odometry.txt");
  BagImages images(FindDrives({Write()})[0], SensorOptions());
  EXPECT_EQ(images.Next()->stamp_ns, 1);
  EXPECT_EQ(images.Next()->stamp_ns, kStepNs);
}

TEST_F(BagImagesTest, WritingRefusesStampsBeforeZeroAndLeavesNothing) {
  dataset_.images[1].stamp_ns = -5;
  EXPECT_THROW(Write(), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "drive.bag"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "drive.bag.active"));
}

TEST_F(BagImagesTest, ACalibrationStandsInForCameraInfo) {
  BagDrive drive = FindDrives({Write()})[0];
  drive.info_topic = "/absent/camera_info";
  try {
    BagImages(drive, SensorOptions());
    FAIL();
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("--calibration"), std::string::npos) << message;
    EXPECT_NE(message.find("/rovio7/camera_info"), std::string::npos) << message;
  }
  BagImages images(drive, SensorOptions(), dataset_.camera);
  EXPECT_EQ(images.Next()->camera, dataset_.camera);
}

TEST_F(BagImagesTest, SaysWhatAMetricMapLacks) {
  BagDrive drive = FindDrives({Write()})[0];
  const auto reason = [](const BagDrive& of, const SensorOptions& options) {
    BagImages images(of, options);
    while (images.Next()) {
    }
    return images.WhyNotMetric().value_or("");
  };
  EXPECT_EQ(reason(drive, SensorOptions()), "");
  SensorOptions other_base;
  other_base.base_frame = "base_footprint";
  const std::string no_tf = reason(drive, other_base);
  EXPECT_NE(no_tf.find("base_footprint"), std::string::npos) << no_tf;
  EXPECT_NE(no_tf.find("rovio7/base_link"), std::string::npos) << no_tf;
  drive.odom_topic = "/absent";
  const std::string no_odometry = reason(drive, SensorOptions());
  EXPECT_NE(no_odometry.find("/rovio7/odom"), std::string::npos) << no_odometry;
}

// Older recordings hold the edges of the mapper that ran beside; here it has another opinion.
TEST_F(BagImagesTest, LeavesOutTheEdgesOfAnEarlierMap) {
  const std::filesystem::path path = Write();
  rosbag::Bag bag(path.string(), rosbag::bagmode::Append);
  tf2_msgs::TFMessage message;
  message.transforms.resize(2);
  message.transforms[0].header.frame_id = "map";
  message.transforms[0].child_frame_id = "session_1/map";
  message.transforms[1].header.frame_id = "session_1/map";
  message.transforms[1].child_frame_id = "rovio7/odom";
  bag.write("/tf", ToTime(kStartNs), message);
  bag.close();
  BagImages images(FindDrives({path})[0], SensorOptions());
  EXPECT_EQ(images.NumMapEdges(), 2u);
}

TEST_F(BagImagesTest, WritingRefusesToReplaceABag) {
  const std::filesystem::path bag = Write();
  EXPECT_THROW(WriteBag(dataset_, "rovio7", bag, false), std::runtime_error);
}

TEST_F(BagImagesTest, WritingRefusesAnOddRobotName) {
  EXPECT_THROW(Write("Rovio 7"), std::runtime_error);
}

}  // namespace
}  // namespace rovio_sfm
