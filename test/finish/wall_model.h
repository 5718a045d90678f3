#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "dense/textured_room.h"
#include "rovio_sfm/scene/map_model.h"

namespace rovio_sfm {

inline constexpr double kWallDepth = 2.0;
inline constexpr std::pair<double, double> kWallPlaces[] = {
    {0.0, 0.0}, {0.2, 0.0}, {-0.2, 0.0}, {0.0, 0.2}, {0.0, -0.2}};

// The textured wall, seen from five places, and some points on it.
inline MapModel WallModel() {
  MapModel model;
  model.length_unit = "metres";
  model.cameras.push_back(SmallCamera());
  for (const auto& [x, y] : kWallPlaces) {
    ModelImage image;
    image.id.index = static_cast<uint32_t>(model.images.size());
    image.cam_from_map.translation = {-x, -y, 0.0};
    model.images.push_back(image);
  }
  for (int i = 0; i < 60; ++i) {
    ModelPoint point;
    point.x_in_map = {0.1 * (i % 10) - 0.45, 0.1 * (i / 10) - 0.3, kWallDepth};
    for (uint32_t view = 0; view < 5; ++view) point.views.push_back({view, 0});
    model.points.push_back(point);
  }
  return model;
}

inline std::shared_ptr<const std::vector<uint8_t>> ReadWall(const ModelImage& image) {
  const auto& [x, y] = kWallPlaces[image.id.index];
  std::vector<uint8_t> png;
  cv::imencode(".png", SeeWall(x, y, kWallDepth), png);
  return std::make_shared<const std::vector<uint8_t>>(std::move(png));
}

}  // namespace rovio_sfm
