#include "rovio_sfm/sim/tour/render_tour.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "sim/world/small_world.h"
#include "util/temporary_folder.h"

namespace rovio_sfm::sim {
namespace {

class RenderTours : public testing::Test {
 protected:
  RenderTours() {
    temp_.Write("config/worlds/small.yaml", SmallWorldYaml());
    temp_.Write("config/tours/short.yaml", SmallTourYaml());
  }

  RenderTourOptions Options(const std::string& out) const {
    RenderTourOptions options;
    options.config_folder = temp_.Path() / "config";
    options.tour = "short";
    options.out_folder = temp_.Path() / out;
    options.max_frames = 2;
    options.render.samples_per_side = 1;
    return options;
  }

  const TemporaryFolder temp_;
};

TEST_F(RenderTours, WritesPicturesOfTheRoviosSize) {
  EXPECT_EQ(RenderTour(Options("a")), 2);
  const cv::Mat picture = cv::imread(temp_.Path() / "a/images/000001.jpg");
  EXPECT_EQ(picture.size(), cv::Size(640, 480));
  EXPECT_NE(ReadText(temp_.Path() / "a/overlaps.txt").find("0 1 "), std::string::npos);
}

TEST_F(RenderTours, BytesDependNeitherOnThreadsNorOnTheTwin) {
  RenderTourOptions threaded = Options("b");
  threaded.num_threads = 2;
  threaded.clean_out_folder = temp_.Path() / "clean";
  RenderTour(Options("a"));
  RenderTour(threaded);
  for (const char* name : {"images/000000.jpg", "images/000001.jpg", "odometry.txt"}) {
    EXPECT_EQ(ReadText(temp_.Path() / "a" / name), ReadText(temp_.Path() / "b" / name)) << name;
  }
  EXPECT_NE(ReadText(temp_.Path() / "a/images/000000.jpg"),
            ReadText(temp_.Path() / "clean/images/000000.jpg"));
}

TEST_F(RenderTours, CalibrationErrsBesideTheTrueOne) {
  RenderTourOptions options = Options("a");
  RenderTour(options);
  const std::string true_camera = ReadText(temp_.Path() / "a/calibration.txt");
  options.out_folder = temp_.Path() / "b";
  options.errs_in_calibration = true;
  RenderTour(options);
  EXPECT_EQ(ReadText(temp_.Path() / "b/calibration_true.txt"), true_camera);
  EXPECT_NE(ReadText(temp_.Path() / "b/calibration.txt"), true_camera);
}

TEST_F(RenderTours, AnotherLightChangesPicturesAndNothingElse) {
  RenderTourOptions options = Options("a");
  RenderTour(options);
  options.out_folder = temp_.Path() / "b";
  options.light = 5;
  RenderTour(options);
  EXPECT_NE(ReadText(temp_.Path() / "a/images/000000.jpg"),
            ReadText(temp_.Path() / "b/images/000000.jpg"));
  for (const char* name : {"groundtruth.txt", "odometry.txt", "overlaps.txt"}) {
    EXPECT_EQ(ReadText(temp_.Path() / "a" / name), ReadText(temp_.Path() / "b" / name)) << name;
  }
}

TEST_F(RenderTours, MoversChangePicturesAndNothingElse) {
  RenderTourOptions options = Options("a");
  options.config_folder = ROVIO_SOURCE_DIR "/config";
  options.tour = "visionlab";
  options.max_frames = 1;
  options.render.samples_per_side = 1;
  RenderTour(options);
  options.out_folder = temp_.Path() / "b";
  options.has_movers = true;
  RenderTour(options);
  EXPECT_NE(ReadText(temp_.Path() / "a/images/000000.jpg"),
            ReadText(temp_.Path() / "b/images/000000.jpg"));
  EXPECT_EQ(ReadText(temp_.Path() / "a/groundtruth.txt"),
            ReadText(temp_.Path() / "b/groundtruth.txt"));
}

TEST_F(RenderTours, NamesAMissingTour) {
  RenderTourOptions options = Options("a");
  options.tour = "nowhere";
  EXPECT_THROW(RenderTour(options), std::runtime_error);
  options.tour = "../short";
  EXPECT_THROW(RenderTour(options), std::runtime_error);
}

}  // namespace
}  // namespace rovio_sfm::sim
