#include "rovio_sfm/sfm/refine_intrinsics.h"

#include <gtest/gtest.h>

#include <utility>

#include "sfm/synthetic_bundle.h"

namespace rovio_sfm {
namespace {

const Eigen::Vector3d kSigma{0.005, 0.003, 0.003};

// A camera that drives once round the points and is calibrated with this error: what it sees,
// normalised by the wrong calibration, at its optimum by that.
struct Drive {
  Drive(const Eigen::Vector3d& true_correction, double noise_px,
        SyntheticMotion motion = SyntheticMotion::kCircle, int num_points = 500)
      : world(WorldOf(noise_px, motion, num_points)), problem(MakeProblem(world)) {
    const Camera given = CorrectedCamera(world.camera, -true_correction);
    for (BundleObservation& observation : problem.observations) {
      const Eigen::Vector2d pixel = PixelFromNormalized(world.camera, observation.x_normalized);
      observation.x_normalized = *NormalizedFromPixel(given, pixel);
    }
    AdjustBundle(&problem, kExact);
    problem.intrinsics.push_back({given, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), kSigma});
  }

  static SyntheticWorld WorldOf(double noise_px, SyntheticMotion motion, int num_points) {
    SyntheticOptions options;
    options.num_points = num_points;
    options.num_cams = 24;
    options.motion = motion;
    options.step = motion == SyntheticMotion::kCircle ? 1.0 : 0.1;
    options.noise_px = noise_px;
    return MakeSyntheticWorld(options);
  }

  const Eigen::Vector3d& correction() const { return problem.intrinsics[0].correction; }
  double Error() const { return ErrorUpToSimilarity(problem, world); }

  SyntheticWorld world;
  BundleProblem problem;
};

TEST(RefineIntrinsics, FindsTheTrueCameraWithoutNoise) {
  const Eigen::Vector3d truth(0.004, -0.003, 0.002);
  Drive drive(truth, 0.0);
  drive.problem.intrinsics[0].sigma *= 100.0;  // else it is drawn to what is expected
  const double before = drive.Error();
  ASSERT_TRUE(RefineIntrinsics(kExact, &drive.problem));
  EXPECT_LT((drive.correction() - truth).norm(), 0.01 * truth.norm());
  EXPECT_LT(drive.Error(), 0.01 * before);
}

TEST(RefineIntrinsics, ComesNearItWithNoise) {
  const Eigen::Vector3d truth(0.004, -0.003, 0.002);
  Drive drive(truth, 0.2);
  const double before = drive.Error();
  ASSERT_TRUE(RefineIntrinsics(kExact, &drive.problem));
  EXPECT_LT((drive.correction() - truth).norm(), 0.4 * truth.norm());
  EXPECT_LT(drive.Error(), 0.6 * before);
}

// A part of the points decides, all are solved for.
TEST(RefineIntrinsics, SolvesLargeProblemsWhole) {
  const Eigen::Vector3d truth(0.004, -0.003, 0.002);
  Drive drive(truth, 0.2, SyntheticMotion::kCircle, 6500);
  ASSERT_GT(drive.problem.observations.size(), 80'000u);
  const double before = drive.Error();
  const std::vector<Eigen::Vector3d> points = drive.problem.points;
  ASSERT_TRUE(RefineIntrinsics(kExact, &drive.problem));
  EXPECT_LT((drive.correction() - truth).norm(), 0.2 * truth.norm());
  EXPECT_LT(drive.Error(), 0.3 * before);
  ASSERT_EQ(drive.problem.points.size(), points.size());
  size_t num_moved = 0;
  for (size_t i = 0; i < points.size(); ++i) num_moved += drive.problem.points[i] != points[i];
  EXPECT_GT(num_moved, points.size() / 4 * 3);  // the others nobody sees
}

void ExpectLeftAlone(Drive drive) {
  const BundleProblem before = drive.problem;
  EXPECT_FALSE(RefineIntrinsics(kExact, &drive.problem));
  EXPECT_EQ(drive.correction(), Eigen::Vector3d::Zero());
  for (size_t i = 0; i < before.cameras.size(); ++i) {
    EXPECT_EQ(drive.problem.cameras[i].cam_from_map.translation,
              before.cameras[i].cam_from_map.translation);
  }
  EXPECT_EQ(drive.problem.points, before.points);
}

TEST(RefineIntrinsics, LeavesACameraThatIsRight) {
  ExpectLeftAlone({Eigen::Vector3d::Zero(), 0.0});
  ExpectLeftAlone({Eigen::Vector3d::Zero(), 0.5});
}

// A calibration does not err by that much: the pictures err in another way.
TEST(RefineIntrinsics, DoesNotBelieveALargeError) {
  for (const int num_points : {500, 5000}) {  // of many points a part is asked first
    ExpectLeftAlone({{0.03, 0.0, 0.02}, 0.5, SyntheticMotion::kCircle, num_points});
  }
}

// What errs so in one half of a drive alone is no calibration.
TEST(RefineIntrinsics, DoesNotBelieveACameraThatChanges) {
  Drive drive({0.004, -0.003, 0.002}, 0.2);
  const Camera& given = drive.problem.intrinsics[0].camera;
  for (BundleObservation& observation : drive.problem.observations) {
    if (2 * observation.camera < drive.problem.cameras.size()) continue;
    const Eigen::Vector2d pixel = PixelFromNormalized(given, observation.x_normalized);
    observation.x_normalized = *NormalizedFromPixel(drive.world.camera, pixel);
  }
  ExpectLeftAlone(std::move(drive));
}

TEST(RefineIntrinsics, LearnsNothingFromAStraightWay) {
  ExpectLeftAlone({{0.004, 0.0, 0.0}, 0.5, SyntheticMotion::kForward});
}

TEST(RefineIntrinsics, NeedsIntrinsicsAndObservations) {
  Drive drive({0.004, -0.003, 0.002}, 0.0);
  BundleProblem without = drive.problem;
  without.intrinsics.clear();
  EXPECT_FALSE(RefineIntrinsics(kExact, &without));
  drive.problem.observations.clear();
  EXPECT_FALSE(RefineIntrinsics(kExact, &drive.problem));
}

}  // namespace
}  // namespace rovio_sfm
