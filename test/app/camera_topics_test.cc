#include "rovio_sfm/app/camera_topics.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

namespace rovio_sfm {
namespace {

using Topics = std::vector<PublishedTopic>;

const Topics kOneCamera = {{"/usb_cam/image_raw", "sensor_msgs/Image"},
                           {"/usb_cam/image_raw/compressed", "sensor_msgs/CompressedImage"},
                           {"/usb_cam/image_raw/theora", "theora_image_transport/Packet"},
                           {"/usb_cam/camera_info", "sensor_msgs/CameraInfo"},
                           {"/rosout", "rosgraph_msgs/Log"}};

std::string ErrorOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(GuessTopic, TakesTheOnlyImagesCompressedWhereTheyAre) {
  const auto image = GuessImageTopic(kOneCamera, {}, kGuessTopic);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->base, "/usb_cam/image_raw");
  EXPECT_EQ(image->transport, "compressed");
  EXPECT_EQ(GuessImageTopic({kOneCamera[0]}, {}, kGuessTopic)->transport, "raw");
  EXPECT_EQ(GuessImageTopic(kOneCamera, {}, "theora")->transport, "theora");
}

TEST(GuessTopic, IsNothingWhileThereIsNone) {
  EXPECT_FALSE(GuessImageTopic({}, {}, kGuessTopic));
  EXPECT_FALSE(GuessImageTopic({{"/r/image", "sensor_msgs/Image"}}, {"/r/image"}, kGuessTopic));
  EXPECT_FALSE(GuessCameraInfoTopic({}, "/a/image_raw"));
  EXPECT_FALSE(GuessOdometryTopic(kOneCamera));
}

TEST(GuessTopic, ListsThemWhereThereAreSeveral) {
  Topics two = kOneCamera;
  two.push_back({"/front/image_rect", "sensor_msgs/Image"});
  EXPECT_EQ(ErrorOf([&] { GuessImageTopic(two, {}, kGuessTopic); }),
            "several topics of type sensor_msgs/Image or CompressedImage: /front/image_rect "
            "/usb_cam/image_raw; choose one with image:=TOPIC");
  const Topics odometries = {{"/wheel", "nav_msgs/Odometry"}, {"/visual", "nav_msgs/Odometry"}};
  EXPECT_EQ(ErrorOf([&] { GuessOdometryTopic(odometries); }),
            "several topics of type nav_msgs/Odometry: /visual /wheel; choose one with "
            "odom:=TOPIC");
}

TEST(GuessTopic, PrefersTheCameraInfoBesideTheImages) {
  Topics two = kOneCamera;
  two.push_back({"/front/camera_info", "sensor_msgs/CameraInfo"});
  EXPECT_EQ(GuessCameraInfoTopic(two, "/front/image_rect"), "/front/camera_info");
  EXPECT_NE(ErrorOf([&] { GuessCameraInfoTopic(two, "/rear/image"); }), "");
  EXPECT_EQ(GuessCameraInfoTopic(kOneCamera, "/elsewhere/image"), "/usb_cam/camera_info");
}

}  // namespace
}  // namespace rovio_sfm
