#include "rovio_sfm/io/export_colmap.h"

#include <limits>

#include "rovio_sfm/io/append_fields.h"
#include "rovio_sfm/io/colmap_camera.h"

namespace rovio_sfm {
namespace {

constexpr uint64_t kNoPoint = std::numeric_limits<uint64_t>::max();  // -1 in text

// The ids of the points that an image's features see, kNoPoint where they see none.
std::vector<std::vector<uint64_t>> PointIds(const MapModel& model) {
  std::vector<std::vector<uint64_t>> ids;
  for (const ModelImage& image : model.images) ids.emplace_back(image.keypoints.size(), kNoPoint);
  for (size_t i = 0; i < model.points.size(); ++i) {
    for (const ModelView& view : model.points[i].views) ids[view.image][view.keypoint] = i + 1;
  }
  return ids;
}

std::string CamerasText(const MapModel& model) {
  std::string text = "# CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n";
  for (size_t i = 0; i < model.cameras.size(); ++i) {
    const ColmapCamera camera = ToColmapCamera(model.cameras[i]);
    AppendFields(&text, i + 1);
    text += " " + camera.model;
    AppendFields(&text, model.cameras[i].width, model.cameras[i].height);
    for (const double parameter : camera.parameters) AppendFields(&text, parameter);
    text += "\n";
  }
  return text;
}

void AppendFeatures(const ModelImage& image, const std::vector<uint64_t>& point_ids,
                    std::string* text) {
  for (size_t i = 0; i < image.keypoints.size(); ++i) {
    const Keypoint& keypoint = image.keypoints[i];
    AppendFields(text, keypoint.x_px + kColmapPixelCentre, keypoint.y_px + kColmapPixelCentre,
                 static_cast<int64_t>(point_ids[i]));
  }
}

std::string ImagesText(const MapModel& model) {
  std::string text =
      "# IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME; then X, Y, POINT3D_ID of each "
      "feature\n# cameras from the map, lengths in " +
      model.length_unit + "\n";
  const auto point_ids = PointIds(model);
  for (size_t i = 0; i < model.images.size(); ++i) {
    const ModelImage& image = model.images[i];
    const Eigen::Quaterniond& q = image.cam_from_map.rotation;
    const Eigen::Vector3d& t = image.cam_from_map.translation;
    AppendFields(&text, i + 1, q.w(), q.x(), q.y(), q.z(), t.x(), t.y(), t.z(), image.camera + 1);
    text += " " + image.name + "\n";
    AppendFeatures(image, point_ids[i], &text);
    text += "\n";
  }
  return text;
}

std::string PointsText(const MapModel& model) {
  std::string text = "# POINT3D_ID, X, Y, Z, R, G, B, ERROR, TRACK[] as (IMAGE_ID, POINT2D_IDX)\n";
  for (size_t i = 0; i < model.points.size(); ++i) {
    const ModelPoint& point = model.points[i];
    const Eigen::Vector3d& x = point.x_in_map;
    AppendFields(&text, i + 1, x.x(), x.y(), x.z());
    for (const int channel : point.color) AppendFields(&text, channel);
    AppendFields(&text, point.error_px);
    for (const ModelView& view : point.views) AppendFields(&text, view.image + 1, view.keypoint);
    text += "\n";
  }
  return text;
}

std::string CamerasBytes(const MapModel& model) {
  std::string bytes;
  AppendBytes<uint64_t>(model.cameras.size(), &bytes);
  for (size_t i = 0; i < model.cameras.size(); ++i) {
    const ColmapCamera camera = ToColmapCamera(model.cameras[i]);
    AppendBytes(static_cast<uint32_t>(i + 1), &bytes);
    AppendBytes(static_cast<int32_t>(camera.model_id), &bytes);
    AppendBytes(static_cast<uint64_t>(model.cameras[i].width), &bytes);
    AppendBytes(static_cast<uint64_t>(model.cameras[i].height), &bytes);
    for (const double parameter : camera.parameters) AppendBytes(parameter, &bytes);
  }
  return bytes;
}

void AppendPose(const Rigid3& cam_from_map, std::string* bytes) {
  const Eigen::Quaterniond& q = cam_from_map.rotation;
  for (const double value : {q.w(), q.x(), q.y(), q.z()}) AppendBytes(value, bytes);
  for (int i = 0; i < 3; ++i) AppendBytes(cam_from_map.translation(i), bytes);
}

std::string ImagesBytes(const MapModel& model) {
  std::string bytes;
  AppendBytes<uint64_t>(model.images.size(), &bytes);
  const auto point_ids = PointIds(model);
  for (size_t i = 0; i < model.images.size(); ++i) {
    const ModelImage& image = model.images[i];
    AppendBytes(static_cast<uint32_t>(i + 1), &bytes);
    AppendPose(image.cam_from_map, &bytes);
    AppendBytes(image.camera + 1, &bytes);
    bytes.append(image.name.c_str(), image.name.size() + 1);
    AppendBytes<uint64_t>(image.keypoints.size(), &bytes);
    for (size_t j = 0; j < image.keypoints.size(); ++j) {
      AppendBytes(image.keypoints[j].x_px + kColmapPixelCentre, &bytes);
      AppendBytes(image.keypoints[j].y_px + kColmapPixelCentre, &bytes);
      AppendBytes(point_ids[i][j], &bytes);
    }
  }
  return bytes;
}

std::string PointsBytes(const MapModel& model) {
  std::string bytes;
  AppendBytes<uint64_t>(model.points.size(), &bytes);
  for (size_t i = 0; i < model.points.size(); ++i) {
    const ModelPoint& point = model.points[i];
    AppendBytes<uint64_t>(i + 1, &bytes);
    for (int j = 0; j < 3; ++j) AppendBytes(point.x_in_map(j), &bytes);
    for (const uint8_t channel : point.color) AppendBytes(channel, &bytes);
    AppendBytes(point.error_px, &bytes);
    AppendBytes<uint64_t>(point.views.size(), &bytes);
    for (const ModelView& view : point.views) {
      AppendBytes(view.image + 1, &bytes);
      AppendBytes(view.keypoint, &bytes);
    }
  }
  return bytes;
}

}  // namespace

std::vector<NamedFile> ColmapTextFiles(const MapModel& model) {
  return {{"cameras.txt", CamerasText(model)},
          {"images.txt", ImagesText(model)},
          {"points3D.txt", PointsText(model)}};
}

std::vector<NamedFile> ColmapBinaryFiles(const MapModel& model) {
  return {{"cameras.bin", CamerasBytes(model)},
          {"images.bin", ImagesBytes(model)},
          {"points3D.bin", PointsBytes(model)}};
}

}  // namespace rovio_sfm
