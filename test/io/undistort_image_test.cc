#include "rovio_sfm/io/undistort_image.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "io/synthetic_model.h"

namespace rovio_sfm {
namespace {

std::vector<uint8_t> EncodeImage(const cv::Mat& image) {
  std::vector<uint8_t> bytes;
  cv::imencode(".png", image, bytes);
  return bytes;
}

TEST(UndistortImage, PutsAPointWhereTheIdealCameraSeesIt) {
  const Camera camera = FullCamera();
  const Camera ideal = IdealCamera(camera);
  for (const auto& x_normalized : {Eigen::Vector2d(0.4, -0.3), Eigen::Vector2d(-0.1, 0.3)}) {
    const Eigen::Vector2d seen = PixelFromNormalized(camera, x_normalized);
    cv::Mat image = cv::Mat::zeros(camera.height, camera.width, CV_8UC3);
    const cv::Point pixel(cvRound(seen.x()), cvRound(seen.y()));
    cv::circle(image, pixel, 6, cv::Scalar::all(255), cv::FILLED);
    const cv::Mat out =
        cv::imdecode(UndistortImage(EncodeImage(image), camera), cv::IMREAD_GRAYSCALE);
    const cv::Moments moments = cv::moments(out);
    const Eigen::Vector2d found(moments.m10 / moments.m00, moments.m01 / moments.m00);
    const auto expected = NormalizedFromPixel(camera, {pixel.x, pixel.y});
    ASSERT_TRUE(expected);
    EXPECT_LT((found - PixelFromNormalized(ideal, *expected)).norm(), 0.5) << found.transpose();
  }
}

TEST(UndistortImage, RefusesAPictureOfAnotherSize) {
  const std::string error =
      MessageOf([] { UndistortImage(EncodeImage(cv::Mat::zeros(10, 20, CV_8UC3)), FullCamera()); });
  EXPECT_NE(error.find("20 x 10"), std::string::npos) << error;
  EXPECT_NE(error.find("640 x 480"), std::string::npos) << error;
}

TEST(UndistortImage, RefusesAPictureWithoutBytes) {
  EXPECT_THROW(UndistortImage({}, Camera()), std::runtime_error);
}

TEST(UndistortImage, RefusesWhatIsNoPicture) {
  EXPECT_FALSE(MessageOf([] { UndistortImage({1, 2, 3}, FullCamera()); }).empty());
}

}  // namespace
}  // namespace rovio_sfm
