#include "rovio_sfm/io/export_nvm.h"

#include <sstream>

#include "io/synthetic_model.h"
#include "rovio_sfm/io/export_colmap.h"

namespace rovio_sfm {
namespace {

struct NvmCamera {
  std::string name;
  double focal = 0.0, distortion = 0.0;
  Eigen::Quaterniond rotation;  // from the model
  Eigen::Vector3d centre;
};

struct NvmView {
  size_t camera = 0, feature = 0;
  Eigen::Vector2d x;
};

struct NvmPoint {
  Eigen::Vector3d x;
  std::vector<NvmView> views;
};

struct NvmScene {
  std::vector<NvmCamera> cameras;
  std::vector<NvmPoint> points;
};

// By VisualSFM's manual.
NvmScene ReadNvm(const std::string& text) {
  std::istringstream in(text);
  std::string head;
  size_t count = 0;
  in >> head >> count;
  EXPECT_EQ(head, "NVM_V3");
  NvmScene scene;
  scene.cameras.resize(count);
  for (NvmCamera& camera : scene.cameras) {
    double w = 0, x = 0, y = 0, z = 0, zero = 1;
    in >> camera.name >> camera.focal >> w >> x >> y >> z >> camera.centre(0) >> camera.centre(1) >>
        camera.centre(2) >> camera.distortion >> zero;
    camera.rotation = Eigen::Quaterniond(w, x, y, z);
    EXPECT_EQ(zero, 0.0);
  }
  in >> count;
  scene.points.resize(count);
  for (NvmPoint& point : scene.points) {
    int red = 0, green = 0, blue = 0;
    in >> point.x(0) >> point.x(1) >> point.x(2) >> red >> green >> blue >> count;
    point.views.resize(count);
    for (NvmView& view : point.views) in >> view.camera >> view.feature >> view.x(0) >> view.x(1);
  }
  EXPECT_TRUE(in) << "the file ends early";
  return scene;
}

TEST(NvmText, ProjectsAsVisualSfmsManualSays) {
  const MapModel model = MakeSyntheticModel(FullCamera());
  const NvmScene scene = ReadNvm(NvmText(model, "images"));
  ASSERT_EQ(scene.cameras.size(), model.images.size());
  ASSERT_EQ(scene.points.size(), model.points.size());
  EXPECT_EQ(scene.cameras[0].name, "images/rovio/frame_0.jpg");
  size_t num_views = 0;
  for (const NvmPoint& point : scene.points) {
    for (const NvmView& view : point.views) {
      const NvmCamera& camera = scene.cameras[view.camera];
      const Eigen::Vector3d in_cam = camera.rotation * (point.x - camera.centre);
      EXPECT_LT((camera.focal * in_cam.hnormalized() - view.x).norm(), 1e-6);
      ++num_views;
    }
  }
  EXPECT_EQ(num_views, NumViews(model));
}

// Of a camera that both formats hold.
TEST(NvmText, SaysWhatColmapsOwnExportSays) {
  const TemporaryFolder folder;
  const MapModel model = MakeSyntheticModel(PlainCamera());
  const std::string sparse = WriteAll(ColmapBinaryFiles(model), "sparse", folder);
  const std::string path = (folder.Path() / "theirs.nvm").string();
  RunProgram("colmap model_converter --output_type NVM --input_path " + sparse + " --output_path " +
             path);
  const NvmScene ours = ReadNvm(NvmText(model, "images")), theirs = ReadNvm(ReadText(path));
  ASSERT_EQ(ours.cameras.size(), theirs.cameras.size());
  ASSERT_EQ(ours.points.size(), theirs.points.size());
  for (size_t i = 0; i < ours.cameras.size(); ++i) {
    const NvmCamera &a = ours.cameras[i], &b = theirs.cameras[i];
    EXPECT_EQ(a.focal, b.focal);
    EXPECT_LT(a.rotation.angularDistance(b.rotation) + (a.centre - b.centre).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace rovio_sfm
