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

TEST(ImageBytes, PlainGreyIsGrey) {
  sensor_msgs::Image message = RgbImage();
  message.encoding = "8UC1";
  message.width = 60;
  std::string error;
  const ImageBytes bytes = BytesOf(message, &error);
  ASSERT_TRUE(bytes) << error;
  const cv::Mat image = cv::imdecode(*bytes, cv::IMREAD_UNCHANGED);
  ASSERT_EQ(image.type(), CV_8UC1);
  EXPECT_EQ(image.at<uint8_t>(3, 5), message.data[3 * 60 + 5]);
}

TEST(ImageBytes, SixteenBitsOfGreyStaySixteen) {
  for (const char* encoding : {"mono16", "16UC1"}) {
    sensor_msgs::Image message = RgbImage();
    message.encoding = encoding;
    message.width = 30;
    std::string error;
    const ImageBytes bytes = BytesOf(message, &error);
    ASSERT_TRUE(bytes) << error;
    const cv::Mat image = cv::imdecode(*bytes, cv::IMREAD_UNCHANGED);
    ASSERT_EQ(image.type(), CV_16UC1);
    EXPECT_EQ(image.at<uint16_t>(0, 1), message.data[2] + 256 * message.data[3]);
  }
}

TEST(ImageBytes, Yuy2IsUnderstood) {
  sensor_msgs::Image message = RgbImage();
  message.encoding = "yuv422_yuy2";
  message.width = 30;
  for (size_t i = 0; i < message.data.size(); ++i) message.data[i] = i % 2 == 0 ? 100 : 128;
  std::string error;
  const ImageBytes bytes = BytesOf(message, &error);
  ASSERT_TRUE(bytes) << error;
  const cv::Mat image = cv::imdecode(*bytes, cv::IMREAD_COLOR);
  ASSERT_EQ(image.size(), cv::Size(30, 16));
  const cv::Vec3b grey = image.at<cv::Vec3b>(2, 3);  // no colour
  EXPECT_EQ(grey[0], grey[2]);
  EXPECT_NEAR(grey[1], 98, 2);
  message.width = 31;  // wider than a row
  EXPECT_FALSE(BytesOf(message, &error));
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
  EXPECT_NE(error.find("encoding smell8"), std::string::npos);
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
