#pragma once

#include <memory>
#include <vector>

#include "dense/textured_room.h"
#include "rovio_sfm/features/denoise.h"
#include "rovio_sfm/features/extract_features.h"
#include "rovio_sfm/scene/map_model.h"

namespace rovio_sfm {

constexpr double kWallDepth = 2.0;
constexpr std::pair<double, double> kWallPlaces[] = {
    {0.0, 0.0}, {0.15, 0.0}, {-0.15, 0.0}, {0.0, 0.15}, {0.0, -0.15}};

inline std::vector<uint8_t> WallPicture(uint32_t index) {
  const auto& [x, y] = kWallPlaces[index];
  std::vector<uint8_t> png;
  cv::imencode(".png", SeeWall(x, y, kWallDepth), png);
  return png;
}

// The textured wall seen from five places, with few stored features, and the points of the plane
// that those see in two images and more.
struct SeenWall {
  MapModel model;
  std::vector<std::shared_ptr<const FrameFeatures>> stored;  // by image

  explicit SeenWall(int num_features = 100) {
    model.length_unit = "metres";
    model.cameras.push_back(SmallCamera());
    for (uint32_t i = 0; i < std::size(kWallPlaces); ++i) AddImage(i, num_features);
    for (uint32_t i = 0; i < model.images.front().keypoints.size(); ++i) AddPoint(i);
  }

 private:
  void AddImage(uint32_t index, int num_features) {
    const auto& [x, y] = kWallPlaces[index];
    ExtractOptions options;
    options.max_features = num_features;
    stored.push_back(std::make_shared<const FrameFeatures>(
        ExtractFeatures(Denoise(SeeWall(x, y, kWallDepth), {}), SmallCamera(), options)));
    ModelImage image;
    image.id = {{"rovio1", 1, 1}, index};
    image.cam_from_map.translation = {-x, -y, 0.0};
    image.keypoints = stored.back()->keypoints;
    model.images.push_back(image);
  }

  // Of a feature of the first image.
  void AddPoint(uint32_t feature) {
    ModelPoint point;
    point.x_in_map =
        kWallDepth * model.images.front().keypoints[feature].x_normalized.homogeneous();
    for (uint32_t i = 0; i < model.images.size(); ++i) {
      const ModelImage& image = model.images[i];
      const Eigen::Vector2d seen = (image.cam_from_map * point.x_in_map).hnormalized();
      for (uint32_t k = 0; k < image.keypoints.size(); ++k) {
        if ((image.keypoints[k].x_normalized - seen).norm() > 0.3 / SmallCamera().fx) continue;
        point.views.push_back({i, k});
        break;
      }
    }
    if (point.views.size() >= 2) model.points.push_back(point);
  }
};

}  // namespace rovio_sfm
