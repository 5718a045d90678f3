#include "rovio_sfm/io/export_nvm.h"

#include "rovio_sfm/io/append_fields.h"
#include "rovio_sfm/io/undistort_image.h"

namespace rovio_sfm {
namespace {

void AppendCamera(const Rigid3& cam_from_map, double focal_px, std::string* text) {
  const Eigen::Quaterniond& q = cam_from_map.rotation;
  const Eigen::Vector3d centre = OriginInA(cam_from_map);
  AppendFields(text, focal_px, q.w(), q.x(), q.y(), q.z(), centre.x(), centre.y(), centre.z(), 0,
               0);
  *text += "\n";
}

void AppendPoint(const MapModel& model, const ModelPoint& point, std::string* text) {
  AppendFields(text, point.x_in_map.x(), point.x_in_map.y(), point.x_in_map.z());
  for (const int channel : point.color) AppendFields(text, channel);
  AppendFields(text, point.views.size());
  for (const ModelView& view : point.views) {
    const ModelImage& image = model.images[view.image];
    const Eigen::Vector2d x_px =
        model.cameras[image.camera].MeanFocal() * image.keypoints[view.keypoint].x_normalized;
    AppendFields(text, view.image, view.keypoint, x_px.x(), x_px.y());
  }
  *text += "\n";
}

}  // namespace

std::string NvmText(const MapModel& model, const std::string& picture_folder) {
  std::string text = "NVM_V3\n\n";
  AppendFields(&text, model.images.size());
  text += "\n";
  for (const ModelImage& image : model.images) {
    text += picture_folder + "/" + UndistortedName(image.name);
    AppendCamera(image.cam_from_map, model.cameras[image.camera].MeanFocal(), &text);
  }
  text += "\n";
  AppendFields(&text, model.points.size());
  text += "\n";
  for (const ModelPoint& point : model.points) AppendPoint(model, point, &text);
  return text + "\n0\n";  // no further model
}

}  // namespace rovio_sfm
