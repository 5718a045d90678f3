#pragma once

#include "rovio_sfm/io/named_file.h"
#include "rovio_sfm/scene/map_model.h"
#include "synthetic/synthetic_world.h"
#include "util/run_program.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {

// Eight cameras on a circle that see 200 points: a world whose views are exact unless noise_px is
// given, in another gauge than its first camera's. The camera has all of our distortion, k3 too.
inline MapModel MakeSyntheticModel(const Camera& camera, double noise_px = 0.0) {
  SyntheticOptions options;
  options.motion = SyntheticMotion::kCircle;
  options.num_cams = 8;
  options.num_points = 200;
  options.noise_px = noise_px;
  const Sim3 map_from_world{1.5, Eigen::Quaterniond(0.8, 0.2, -0.5, 0.1).normalized(), {3, -2, 5}};
  const SyntheticWorld world = TransformWorld(map_from_world, MakeSyntheticWorld(options));
  MapModel model;
  model.length_unit = "metres";
  model.cameras = {camera};
  for (const Eigen::Vector3d& point : world.points) model.points.push_back({point, {}, 0.25, {}});
  for (uint32_t i = 0; i < world.views.size(); ++i) {
    ModelImage image{{{"rovio", 5, 6}, i}, i * 100'000'000, "", 0, world.cams_from_map[i], {}};
    image.name = "rovio/frame_" + std::to_string(i) + ".jpg";
    for (const SyntheticView& view : world.views[i]) {
      const Eigen::Vector2d x_px = PixelFromNormalized(camera, view.x_normalized);
      Keypoint keypoint;
      keypoint.x_px = static_cast<float>(x_px.x());
      keypoint.y_px = static_cast<float>(x_px.y());
      keypoint.size_px = 4.0f;
      keypoint.x_normalized = view.x_normalized;
      model.points[view.point].views.push_back({i, static_cast<uint32_t>(image.keypoints.size())});
      model.points[view.point].color = {10, 20, 30};
      image.keypoints.push_back(keypoint);
    }
    image.keypoints.emplace_back();  // a feature that sees no point
    model.images.push_back(std::move(image));
  }
  const auto is_seldom = [](const ModelPoint& point) { return point.views.size() < 2; };
  model.points.erase(std::remove_if(model.points.begin(), model.points.end(), is_seldom),
                     model.points.end());
  return model;
}

inline Camera FullCamera() {
  return {517.3, 516.5, 318.6, 255.3, 0.2624, -0.9531, -0.0054, 0.0026, 1.1633, 640, 480};
}

// Without distortion, square pixels, the principal point at the picture's centre.
inline Camera PlainCamera() { return {500.0, 500.0, 319.5, 239.5, 0, 0, 0, 0, 0, 640, 480}; }

inline size_t NumViews(const MapModel& model) {
  size_t count = 0;
  for (const ModelPoint& point : model.points) count += point.views.size();
  return count;
}

// Writes the files of an export below a folder and returns it.
inline std::string WriteAll(const std::vector<NamedFile>& files, const std::string& name,
                            const TemporaryFolder& folder) {
  for (const NamedFile& file : files) folder.Write(name + "/" + file.name, file.content);
  return (folder.Path() / name).string();
}

}  // namespace rovio_sfm
