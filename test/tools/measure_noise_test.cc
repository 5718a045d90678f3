#include "rovio_sfm/tools/measure_noise.h"

#include <opencv2/imgcodecs.hpp>

#include "rovio_sfm/tools/list_images.h"
#include "rovio_sfm/util/rng.h"
#include "tools/command_line.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

// Pictures of a wall that is brighter on the right, each with its own exposure and noise.
void WritePictures(const TemporaryFolder& folder, int count, double sigma) {
  Rng rng(1);
  for (int i = 0; i < count; ++i) {
    cv::Mat picture(60, 80, CV_8UC3);
    for (int y = 0; y < picture.rows; ++y) {
      for (int x = 0; x < picture.cols; ++x) {
        for (int c = 0; c < 3; ++c) {
          const double level = 100.0 + 0.5 * x + 2.0 * i + sigma * rng.Gaussian();
          picture.at<cv::Vec3b>(y, x)[c] = cv::saturate_cast<uint8_t>(level);
        }
      }
    }
    cv::imwrite((folder.Path() / (std::to_string(i) + ".png")).string(), picture);
  }
}

TEST(MeasureNoise, FindsSigmaUnderUnevenLightAndExposure) {
  const TemporaryFolder folder;
  WritePictures(folder, 8, 10.0);
  const NoiseReport report = MeasureNoise(ListImages({folder.Path()}));
  EXPECT_EQ(report.num_pictures, 8u);
  EXPECT_NEAR(report.sigma, 10.0, 0.1);
  for (const double sigma : report.sigma_bgr) EXPECT_NEAR(sigma, 10.0, 0.2);
  EXPECT_EQ(report.clipped_share, 0.0);
}

TEST(MeasureNoise, FindsAlmostNothingWithoutNoise) {
  const TemporaryFolder folder;
  WritePictures(folder, 4, 0.0);
  EXPECT_LT(MeasureNoise(ListImages({folder.Path()})).sigma, 0.5);
}

TEST(MeasureNoise, RefusesOnePictureAndMixedSizes) {
  const TemporaryFolder folder;
  WritePictures(folder, 1, 1.0);
  EXPECT_THROW(MeasureNoise(ListImages({folder.Path()})), std::runtime_error);
  cv::imwrite((folder.Path() / "b.png").string(), cv::Mat(30, 30, CV_8UC3, cv::Scalar::all(9)));
  EXPECT_THROW(MeasureNoise(ListImages({folder.Path()})), std::runtime_error);
}

TEST(MeasureNoiseCommand, PrintsSigma) {
  const TemporaryFolder folder;
  WritePictures(folder, 3, 5.0);
  std::string printed;
  ASSERT_EQ(RunCommand(MeasureNoiseCommand, {folder.Path()}, &printed), 0);
  EXPECT_NE(printed.find("pictures 3\nsigma "), std::string::npos) << printed;
}

}  // namespace
}  // namespace rovio_sfm
