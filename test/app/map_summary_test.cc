#include "rovio_sfm/app/map_summary.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/small_snapshot.h"
#include "rovio_sfm/report/level_map.h"

namespace rovio_sfm {
namespace {

// A run over ten images of which nine were accepted and seven registered, on a bent path.
MapRun SmallRun() {
  SessionSnapshot session = SmallSession(1, 8, {SmallLandmark(1, 4, 0.001)});
  FrameBlock frames = *session.frames.front();
  for (FrameSnapshot& frame : frames) {
    frame.cam_from_session.translation.y() = 0.1 * frame.index * frame.index;
  }
  session.frames = {std::make_shared<const FrameBlock>(frames)};
  MapSnapshot snapshot;
  snapshot.sessions = {session};
  MapRun run;
  run.num_images = 10;
  run.snapshot = std::make_shared<const MapSnapshot>(snapshot);
  run.frontend.keyframes = 4;
  run.frontend.light_frames = 5;
  run.funnel = {3, 3000, 1200, 1100, 1000, 900, 950};
  run.stages["match"] = {10, 50'000'000};
  return run;
}

// What the drive of the only session came from.
DriveInput& GiveInput(MapRun* run) {
  const DriveId& drive = run->snapshot->sessions[0].drive;
  run->drives[drive] = run->inputs.size();
  run->inputs.emplace_back().robot = drive.robot;
  return run->inputs.back();
}

TEST(MapSummaryJson, CountsImagesAndLeavesOutWhatIsNotKnown) {
  const auto json = MapSummaryJson(SmallRun());
  EXPECT_EQ(json["frames"], 10);
  EXPECT_EQ(json["dropped"], 1);
  EXPECT_EQ(json["registered"], 7);
  EXPECT_EQ(json["sessions"], 1);
  EXPECT_EQ(json["landmarks"], 1);
  EXPECT_TRUE(json["ate_rmse_m"].is_null());
  EXPECT_TRUE(json["scale_error"].is_null());
  EXPECT_TRUE(json["odometry_delay_s"].is_null());
  EXPECT_EQ(json["ms_per_frame"]["match"], 5.0);
  EXPECT_EQ(json["matching"]["mean_features"], 1000.0);
  EXPECT_EQ(json["matching"]["ransac_share"], 0.3);
}

TEST(MapSummaryJson, CountsTheNamedImagesThatHaveNoPose) {
  MapRun run = SmallRun();
  EXPECT_EQ(CountImagesWithoutPose(run), 0u);
  const SessionSnapshot& session = run.snapshot->sessions[0];
  GiveInput(&run).image_names = {session.frames.front()->front().image_name, "nowhere.png",
                                 "lost.png"};
  EXPECT_EQ(CountImagesWithoutPose(run), 2u);
  EXPECT_EQ(MapSummaryJson(run)["images_without_pose"][session.drive.robot].size(), 2u);
}

TEST(MapSummaryJson, TellsWhichCalibrationsThePicturesToldOtherwise) {
  MapRun run = SmallRun();
  EXPECT_TRUE(MapSummaryJson(run)["refined_cameras"].empty());
  EXPECT_EQ(RefinedCameras(run), "");
  MapSnapshot snapshot = *run.snapshot;
  SessionSnapshot& session = snapshot.sessions[0];
  session.given_camera = session.camera;
  session.camera = CorrectedCamera(session.given_camera, {0.005, 0.0, 0.0});
  session.camera.cy += 1.25;
  run.snapshot = std::make_shared<const MapSnapshot>(snapshot);
  const auto cameras = MapSummaryJson(run)["refined_cameras"];
  ASSERT_EQ(cameras.size(), 1u);
  EXPECT_EQ(cameras[0]["robot"], session.drive.robot);
  EXPECT_EQ(cameras[0]["fx"], session.camera.fx);
  EXPECT_EQ(RefinedCameras(run), session.drive.robot +
                                     ": the pictures correct the calibration: focal length "
                                     "+0.50 %, centre (+0.00, +1.25) px\n");
}

TEST(MapSummaryJson, NamesTheImagesWithoutAPose) {
  MapRun run = SmallRun();
  const FrameSnapshot& posed = run.snapshot->sessions[0].frames.front()->front();
  GiveInput(&run).image_names = {posed.image_name, "lost.jpg"};
  const auto without = MapSummaryJson(run)["images_without_pose"];
  EXPECT_EQ(without["rovio"], nlohmann::ordered_json({"lost.jpg"}));
}

// Folders are called alike from run to run, and so may be their files.
TEST(MapSummaryJson, TakesNoImageOfAnEarlierRunForOneOfThis) {
  MapRun run = SmallRun();
  const FrameSnapshot& posed = run.snapshot->sessions[0].frames.front()->front();
  GiveInput(&run).image_names = {posed.image_name};
  run.inputs[0].ground_truth = {StampedPose{}};
  run.drives.clear();
  const auto json = MapSummaryJson(run);
  EXPECT_EQ(json["images_without_pose"]["rovio"].size(), 1u);
  EXPECT_TRUE(json["ate_rmse_m"].is_null());
}

TEST(MapSummaryJson, ComparesAMetricMapWithTheTruth) {
  MapRun run = SmallRun();
  DriveInput& input = GiveInput(&run);
  for (const PosedImage& image : PosedImages(*FindLargestMap(*run.snapshot))) {
    StampedPose truth = image.level_from_camera;
    truth.reference_from_body.translation *= 1.1;
    input.ground_truth.push_back(truth);
  }
  EXPECT_NEAR(MapSummaryJson(run)["ate_rmse_m"].get<double>(), 0.0, 1e-9);
  EXPECT_TRUE(MapSummaryJson(run)["scale_error"].is_null());
  MapSnapshot metric = *run.snapshot;
  metric.sessions[0].scale = MapScale{1.0, 0.02, "odometry"};
  run.snapshot = std::make_shared<const MapSnapshot>(metric);
  EXPECT_NEAR(MapSummaryJson(run)["scale_error"].get<double>(), 0.1, 1e-9);
  EXPECT_EQ(MapSummaryJson(run)["scale_inside_two_sigma"], false);
  metric.sessions[0].scale->sigma_log = 0.06;
  run.snapshot = std::make_shared<const MapSnapshot>(metric);
  EXPECT_EQ(MapSummaryJson(run)["scale_inside_two_sigma"], true);
}

TEST(MapSummaryJson, SurvivesARunWithoutAnyMap) {
  MapRun run;
  run.num_images = 3;
  run.snapshot = std::make_shared<const MapSnapshot>();
  const auto json = MapSummaryJson(run);
  EXPECT_EQ(json["registered"], 0);
  EXPECT_EQ(json["maps"], 0);
  EXPECT_EQ(json["dropped"], 3);
  EXPECT_TRUE(json["matching"].is_null());
}

TEST(DensifyJson, TellsBeforeAndAfter) {
  DensifyCounts counts;
  counts.before = {10, 30, 0.5, 0.2};
  counts.after = {25, 90, 0.75, 0.3};
  const auto json = DensifyJson(counts);
  EXPECT_EQ(json["landmarks_before"], 10);
  EXPECT_EQ(json["landmarks"], 25);
  EXPECT_EQ(json["projections"], 90);
  EXPECT_EQ(json["rms_n"], 0.75);
}

}  // namespace
}  // namespace rovio_sfm
