#include <gtest/gtest.h>

#include "mapping/mapped_drive.h"
#include "rovio_sfm/mapping/adjust_session.h"

namespace rovio_sfm {
namespace {

// A drive round the points whose camera was calibrated with an error.
struct WronglyCalibrated {
  explicit WronglyCalibrated(const Eigen::Vector3d& error) {
    SyntheticDriveOptions options;
    options.world.noise_px = 0.1;
    options.world.num_points = 200;
    options.world.num_cams = 24;
    options.world.step = 1.0;
    drive = MakeSyntheticDrive(options);
    const Camera truth = drive.world.camera;
    drive.world.camera = CorrectedCamera(truth, error);
    for (FrameEvent& event : drive.events) {
      auto features = std::make_shared<FrameFeatures>(*event.features);
      for (Keypoint& keypoint : features->keypoints) {
        const Eigen::Vector2d x_px = PixelFromNormalized(truth, keypoint.x_normalized);
        keypoint.x_normalized = *NormalizedFromPixel(drive.world.camera, x_px);
      }
      event.camera = drive.world.camera;
      event.features = std::move(features);
    }
  }

  double ErrorOf(const MapperOptions& options) {
    Session session = MappedDrive(drive);
    AdjustWithCamera(options, &session);
    EXPECT_EQ(CheckInvariants(session), "");
    correction = CorrectionOf(session.given_camera(), session.camera());
    return MeasureTrajectory(session.Snapshot(), drive.world)->max_distance;
  }

  SyntheticDrive drive;
  Eigen::Vector3d correction;
};

TEST(AdjustWithCamera, FindsWhatACalibrationErrsByAndMapsSo) {
  const Eigen::Vector3d error(0.004, 0.003, -0.003);
  WronglyCalibrated wrong(error);
  MapperOptions exact;
  exact.adjust.focal_sigma = 0.0;
  const double trusted = wrong.ErrorOf(exact);
  EXPECT_EQ(wrong.correction, Eigen::Vector3d::Zero());
  EXPECT_LT(wrong.ErrorOf({}), 0.6 * trusted);
  EXPECT_LT((wrong.correction + error).norm(), 0.4 * error.norm());
}

TEST(AdjustWithCamera, LeavesLargeSessionsAndRightCamerasAlone) {
  WronglyCalibrated wrong({0.004, 0.003, -0.003}), right(Eigen::Vector3d::Zero());
  MapperOptions small;
  small.adjust.max_global_frames = 10;
  wrong.ErrorOf(small);
  EXPECT_EQ(wrong.correction, Eigen::Vector3d::Zero());
  right.ErrorOf({});
  EXPECT_EQ(right.correction, Eigen::Vector3d::Zero());
}

}  // namespace
}  // namespace rovio_sfm
