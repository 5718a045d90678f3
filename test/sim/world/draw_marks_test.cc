#include "rovio_sfm/sim/world/draw_marks.h"

#include <gtest/gtest.h>

namespace rovio_sfm::sim {
namespace {

TEST(DrawMarks, EachKnownMarkChangesThePicture) {
  TextureSpec spec;
  spec.width_px = 200;
  spec.height_px = 200;
  for (const std::string& mark : KnownMarks()) {
    Rng rng(3);
    cv::Mat image(200, 200, CV_8UC3, cv::Scalar::all(128));
    DrawMarks(mark, spec, rng, &image);
    EXPECT_GT(cv::countNonZero(image.reshape(1) != 128), 50) << mark;
  }
}

TEST(DrawMarks, HolesAreTruePeriods) {
  TextureSpec spec;
  spec.width_px = spec.height_px = 128;
  spec.period_px = 32;
  Rng rng(3);
  cv::Mat image(128, 128, CV_8UC3, cv::Scalar::all(128));
  DrawMarks("holes", spec, rng, &image);
  const cv::Mat left = image(cv::Rect(0, 0, 32, 128)), right = image(cv::Rect(64, 0, 32, 128));
  EXPECT_EQ(cv::norm(left, right, cv::NORM_INF), 0.0);
}

}  // namespace
}  // namespace rovio_sfm::sim
