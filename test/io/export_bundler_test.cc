#include "rovio_sfm/io/export_bundler.h"

#include <sstream>

#include "io/synthetic_model.h"
#include "rovio_sfm/io/export_colmap.h"

namespace rovio_sfm {
namespace {

struct BundlerCamera {
  double focal = 0.0, k1 = 0.0, k2 = 0.0;
  Eigen::Matrix3d rotation;
  Eigen::Vector3d translation;
};

struct BundlerView {
  size_t camera = 0, key = 0;
  Eigen::Vector2d x;
};

struct BundlerPoint {
  Eigen::Vector3d x;
  Eigen::Vector3d color;
  std::vector<BundlerView> views;
};

struct BundlerScene {
  std::vector<BundlerCamera> cameras;
  std::vector<BundlerPoint> points;
};

void ReadCamera(std::istream& in, BundlerCamera* camera) {
  in >> camera->focal >> camera->k1 >> camera->k2;
  for (int i = 0; i < 9; ++i) in >> camera->rotation(i / 3, i % 3);
  for (int i = 0; i < 3; ++i) in >> camera->translation(i);
}

void ReadPoint(std::istream& in, BundlerPoint* point) {
  for (int i = 0; i < 3; ++i) in >> point->x(i);
  for (int i = 0; i < 3; ++i) in >> point->color(i);
  size_t num_views = 0;
  in >> num_views;
  point->views.resize(num_views);
  for (BundlerView& view : point->views) in >> view.camera >> view.key >> view.x(0) >> view.x(1);
}

// By Bundler's manual, v0.3.
BundlerScene ReadBundle(const std::string& text) {
  std::istringstream in(text);
  std::string head;
  std::getline(in, head);
  EXPECT_EQ(head, "# Bundle file v0.3");
  size_t num_cameras = 0, num_points = 0;
  in >> num_cameras >> num_points;
  BundlerScene scene;
  scene.cameras.resize(num_cameras);
  scene.points.resize(num_points);
  for (BundlerCamera& camera : scene.cameras) ReadCamera(in, &camera);
  for (BundlerPoint& point : scene.points) ReadPoint(in, &point);
  EXPECT_TRUE(in) << "the file ends early";
  std::string rest;
  EXPECT_FALSE(in >> rest) << rest;
  return scene;
}

// P = R X + t, p = -P / P.z, x = f p.
Eigen::Vector2d Project(const BundlerCamera& camera, const Eigen::Vector3d& x) {
  const Eigen::Vector3d in_cam = camera.rotation * x + camera.translation;
  return camera.focal * -in_cam.head<2>() / in_cam.z();
}

TEST(BundlerFiles, ProjectAsBundlersManualSays) {
  const MapModel model = MakeSyntheticModel(FullCamera());
  const BundlerScene scene = ReadBundle(BundlerFiles(model, "images")[0].content);
  ASSERT_EQ(scene.cameras.size(), model.images.size());
  ASSERT_EQ(scene.points.size(), model.points.size());
  size_t num_views = 0;
  for (const BundlerPoint& point : scene.points) {
    for (const BundlerView& view : point.views) {
      EXPECT_LT((Project(scene.cameras[view.camera], point.x) - view.x).norm(), 1e-6);
      ++num_views;
    }
  }
  EXPECT_EQ(num_views, NumViews(model));
}

// Of a camera that both formats hold.
TEST(BundlerFiles, SayWhatColmapsOwnExportSays) {
  const TemporaryFolder folder;
  const MapModel model = MakeSyntheticModel(PlainCamera());
  const std::string sparse = WriteAll(ColmapBinaryFiles(model), "sparse", folder);
  RunProgram("colmap model_converter --output_type Bundler --input_path " + sparse +
             " --output_path " + (folder.Path() / "theirs").string());
  const BundlerScene ours = ReadBundle(BundlerFiles(model, "images")[0].content);
  const BundlerScene theirs = ReadBundle(ReadText(folder.Path() / "theirs.bundle.out"));
  ASSERT_EQ(ours.cameras.size(), theirs.cameras.size());
  ASSERT_EQ(ours.points.size(), theirs.points.size());
  for (size_t i = 0; i < ours.cameras.size(); ++i) {
    const BundlerCamera &a = ours.cameras[i], &b = theirs.cameras[i];
    EXPECT_EQ(a.focal, b.focal);
    EXPECT_LT((a.rotation - b.rotation).norm() + (a.translation - b.translation).norm(), 1e-9);
  }
}

TEST(BundlerFiles, ListThePicturesWithTheirFolder) {
  const std::string list = BundlerFiles(MakeSyntheticModel(FullCamera()), "images")[1].content;
  EXPECT_EQ(list.substr(0, list.find('\n')), "images/rovio/frame_0.jpg");
}

}  // namespace
}  // namespace rovio_sfm
