#include "rovio_sfm/sim/tour/tour_folder.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "rovio_sfm/sim/robot/robot_body.h"
#include "util/temporary_folder.h"

namespace rovio_sfm::sim {
namespace {

TEST(TourFolder, WritesTheLayoutOfADataSet) {
  const TemporaryFolder temp;
  const TourFolder folder(temp.Path() / "set", false);
  SimulatedTour tour;
  tour.frames.resize(2);
  tour.frames[1].time_s = 2.5;
  tour.frames[1].world_from_camera.translation = {1.0, 2.0, 3.0};
  folder.WriteFrames(tour);
  folder.WriteImage(1, {0xff, 0xd8});
  EXPECT_NE(ReadText(temp.Path() / "set/times.txt").find("2.500000 images/000001.jpg\n"),
            std::string::npos);
  EXPECT_NE(ReadText(temp.Path() / "set/groundtruth.txt")
                .find("2.500000000 1.000000000 2.000000000 3.000000000 0.000000000"),
            std::string::npos);
  EXPECT_EQ(ReadText(temp.Path() / "set/images/000001.jpg").size(), 2u);
  EXPECT_FALSE(ReadText(temp.Path() / "set/odometry.txt").empty());
  EXPECT_FALSE(ReadText(temp.Path() / "set/extrinsics.txt").empty());
}

TEST(TourFolder, WritesCalibrationAndOverlaps) {
  const TemporaryFolder temp;
  const TourFolder folder(temp.Path(), false);
  folder.WriteCalibration("calibration.txt", RovioCamera());
  folder.WriteOverlaps("overlaps.txt", {{0, 3, 0.25, M_PI / 18}});
  EXPECT_NE(ReadText(temp.Path() / "calibration.txt").find("699.282000 687.529000 322.005000"),
            std::string::npos);
  EXPECT_NE(ReadText(temp.Path() / "overlaps.txt").find("0 3 0.2500 10.0000"), std::string::npos);
}

TEST(TourFolder, RefusesADataSetThatIsThere) {
  const TemporaryFolder temp;
  temp.Write("times.txt", "");
  EXPECT_THROW(TourFolder(temp.Path(), false), std::runtime_error);
  EXPECT_NO_THROW(TourFolder(temp.Path(), true));
}

TEST(TourFolder, NamesAFolderThatItCannotMake) {
  EXPECT_THROW(TourFolder("/proc/nowhere", false), std::runtime_error);
}

}  // namespace
}  // namespace rovio_sfm::sim
