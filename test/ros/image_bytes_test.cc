#include "rovio_sfm/ros/image_bytes.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

namespace rovio_sfm {
namespace {

sensor_msgs::Image RgbImage() {
  sensor_msgs::Image message;
  message.width = 20;
  message.height = 16;
  message.encoding = "rgb8";
  message.step = 60;
  for (size_t i = 0; i < 960; ++i) message.data.push_back(static_cast<uint8_t>(i));
  return message;
}

TEST(ImageBytes, RawImageIsPackedWithoutLoss) {
  const sensor_msgs::Image message = RgbImage();
  std::string error;
  const ImageBytes bytes = BytesOf(message, &error);
  ASSERT_TRUE(bytes) << error;
  const cv::Mat image = cv::imdecode(*bytes, cv::IMREAD_COLOR);
  ASSERT_EQ(image.size(), cv::Size(20, 16));
  const cv::Vec3b bgr = image.at<cv::Vec3b>(3, 5);
  const size_t offset = 3 * 60 + 5 * 3;
  EXPECT_EQ(bgr,
            cv::Vec3b(message.data[offset + 2], message.data[offset + 1], message.data[offset]));
}

TEST(ImageBytes, ShortRawImageIsRefused) {
  sensor_msgs::Image message = RgbImage();
  message.data.pop_back();
  std::string error;
  EXPECT_FALSE(BytesOf(message, &error));
  EXPECT_NE(error.find("step * height"), std::string::npos);
}

TEST(ImageBytes, StepShorterThanARowIsRefused) {
  sensor_msgs::Image message = RgbImage();
  message.step = 30;
  message.data.resize(30 * 16);
  std::string error;
  EXPECT_FALSE(BytesOf(message, &error));
}

TEST(ImageBytes, UnknownEncodingIsRefused) {
  sensor_msgs::Image message = RgbImage();
  message.encoding = "smell8";
  std::string error;
  EXPECT_FALSE(BytesOf(message, &error));
  EXPECT_NE(error.find("encoding"), std::string::npos);
}

TEST(ImageBytes, CompressedImageKeepsItsBytes) {
  sensor_msgs::CompressedImage message;
  message.data = {0xFF, 0xD8, 1, 2, 0xFF, 0xD9};
  std::string error;
  const ImageBytes bytes = BytesOf(message, &error);
  ASSERT_TRUE(bytes) << error;
  EXPECT_EQ(*bytes, message.data);
}

TEST(ImageBytes, CompressedImageOfAnotherKindIsRefused) {
  sensor_msgs::CompressedImage message;
  std::string error;
  EXPECT_FALSE(BytesOf(message, &error));
  message.data = {'G', 'I', 'F', '8', '9'};
  EXPECT_FALSE(BytesOf(message, &error));
}

}  // namespace
}  // namespace rovio_sfm
