#include "rovio_sfm/io/export_bundler.h"

#include "rovio_sfm/io/append_fields.h"
#include "rovio_sfm/io/undistort_image.h"

namespace rovio_sfm {
namespace {

void AppendRow(const Eigen::RowVector3d& row, std::string* text) {
  AppendFields(text, row.x(), row.y(), row.z());
  *text += "\n";
}

// From our camera (y down, looking along z) half a turn about x.
void AppendCamera(const Rigid3& cam_from_map, double focal_px, std::string* text) {
  const Eigen::DiagonalMatrix<double, 3> half_turn(1.0, -1.0, -1.0);
  const Eigen::Matrix3d rotation = half_turn * cam_from_map.rotation.toRotationMatrix();
  AppendFields(text, focal_px, 0, 0);
  *text += "\n";
  for (int i = 0; i < 3; ++i) AppendRow(rotation.row(i), text);
  AppendRow((half_turn * cam_from_map.translation).transpose(), text);
}

void AppendPoint(const MapModel& model, const ModelPoint& point, std::string* text) {
  AppendRow(point.x_in_map.transpose(), text);
  for (const int channel : point.color) AppendFields(text, channel);
  *text += "\n";
  AppendFields(text, point.views.size());
  for (const ModelView& view : point.views) {
    const ModelImage& image = model.images[view.image];
    const Eigen::Vector2d x_px =
        model.cameras[image.camera].MeanFocal() * image.keypoints[view.keypoint].x_normalized;
    AppendFields(text, view.image, view.keypoint, x_px.x(), -x_px.y());
  }
  *text += "\n";
}

}  // namespace

std::vector<NamedFile> BundlerFiles(const MapModel& model, const std::string& picture_folder) {
  std::string text = "# Bundle file v0.3\n", list;
  AppendFields(&text, model.images.size(), model.points.size());
  text += "\n";
  for (const ModelImage& image : model.images) {
    AppendCamera(image.cam_from_map, model.cameras[image.camera].MeanFocal(), &text);
    list += picture_folder + "/" + UndistortedName(image.name) + "\n";
  }
  for (const ModelPoint& point : model.points) AppendPoint(model, point, &text);
  return {{"bundle.out", text}, {"list.txt", list}};
}

}  // namespace rovio_sfm
