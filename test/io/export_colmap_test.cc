#include "rovio_sfm/io/export_colmap.h"

#include <cmath>
#include <sstream>

#include "io/synthetic_model.h"

namespace rovio_sfm {
namespace {

// The intrinsics stay, one step is taken: the cost before it is that of the model as it was.
double InitialCostPx(const std::string& model, const TemporaryFolder& folder) {
  const std::filesystem::path out = folder.Path() / "adjusted";
  std::filesystem::create_directories(out);
  const std::string printed = RunProgram(
      "colmap bundle_adjuster --input_path " + model + " --output_path " + out.string() +
      " --BundleAdjustment.refine_focal_length 0 --BundleAdjustment.refine_extra_params 0"
      " --BundleAdjustment.max_num_iterations 1");
  return FigureAfter("Initial cost :", printed);
}

std::string AnalyzeModel(const std::string& model) {
  return RunProgram("colmap model_analyzer --path " + model);
}

void ExpectCounts(const MapModel& model, const std::string& printed) {
  EXPECT_EQ(FigureAfter("Cameras:", printed), 1.0);
  EXPECT_EQ(FigureAfter("Registered images:", printed), static_cast<double>(model.images.size()));
  EXPECT_EQ(FigureAfter("Points:", printed), static_cast<double>(model.points.size()));
  EXPECT_EQ(FigureAfter("Observations:", printed), static_cast<double>(NumViews(model)));
}

TEST(ColmapExport, ColmapCountsWhatTheModelHolds) {
  const TemporaryFolder folder;
  const MapModel model = MakeSyntheticModel(FullCamera());
  ExpectCounts(model, AnalyzeModel(WriteAll(ColmapTextFiles(model), "text", folder)));
  ExpectCounts(model, AnalyzeModel(WriteAll(ColmapBinaryFiles(model), "binary", folder)));
}

// Poses, points, features and all of the distortion: one convention amiss, and the cost is pixels.
TEST(ColmapExport, ColmapFindsExactViewsExact) {
  const TemporaryFolder folder;
  Camera without_k3 = FullCamera();
  without_k3.k3 = 0.0;
  for (const Camera& camera : {FullCamera(), without_k3, PlainCamera()}) {
    const MapModel model = MakeSyntheticModel(camera);
    EXPECT_LT(InitialCostPx(WriteAll(ColmapTextFiles(model), "text", folder), folder), 1e-4);
    EXPECT_LT(InitialCostPx(WriteAll(ColmapBinaryFiles(model), "binary", folder), folder), 1e-4);
  }
}

// COLMAP prints the root of half the mean squared residual per coordinate.
TEST(ColmapExport, ColmapFindsTheErrorOfNoisyViews) {
  const TemporaryFolder folder;
  const MapModel model = MakeSyntheticModel(PlainCamera(), 0.5);
  double squared = 0.0;
  for (const ModelPoint& point : model.points) {
    for (const ModelView& view : point.views) {
      const ModelImage& image = model.images[view.image];
      const Eigen::Vector2d seen = (image.cam_from_map * point.x_in_map).hnormalized();
      squared += (500.0 * (seen - image.keypoints[view.keypoint].x_normalized)).squaredNorm();
    }
  }
  const double rms_px = std::sqrt(squared / (2.0 * static_cast<double>(NumViews(model))));
  const double cost_px = InitialCostPx(WriteAll(ColmapTextFiles(model), "text", folder), folder);
  EXPECT_NEAR(cost_px * std::sqrt(2.0), rms_px, 1e-3 * rms_px);
}

TEST(ColmapExport, WritesIdsQuaternionsAndPixelsAsColmapCountsThem) {
  MapModel model = MakeSyntheticModel(PlainCamera());
  model.images.resize(1);
  model.images[0].cam_from_map = {Eigen::Quaterniond(0.5, 0.1, 0.7, -0.5), {1.0, 2.0, 3.0}};
  model.images[0].keypoints.resize(2);
  model.images[0].keypoints[0].x_px = 10.0f;
  model.images[0].keypoints[0].y_px = 20.0f;
  model.images[0].keypoints[1] = {};
  model.points.resize(1);
  model.points[0].x_in_map = {4.0, 5.0, 6.0};
  model.points[0].views = {{0, 0}};
  const std::vector<NamedFile> files = ColmapTextFiles(model);
  EXPECT_NE(files[0].content.find("\n1 PINHOLE 640 480 500 500 320 240\n"), std::string::npos);
  EXPECT_NE(files[1].content.find(
                "\n1 0.5 0.1 0.7 -0.5 1 2 3 1 rovio/frame_0.jpg\n10.5 20.5 1 0.5 0.5 -1\n"),
            std::string::npos)
      << files[1].content;
  EXPECT_NE(files[2].content.find("\n1 4 5 6 10 20 30 0.25 1 0\n"), std::string::npos)
      << files[2].content;
}

}  // namespace
}  // namespace rovio_sfm
