#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/sim/world/lens_table.h"
#include "rovio_sfm/sim/world/mover.h"
#include "rovio_sfm/sim/world/world.h"

namespace rovio_sfm::sim {

struct RenderOptions {
  int samples_per_side = 2;  // a pixel has this squared stratified samples; 1 … 8
  // Share of the shutter's motion that passes between the first row's and the last row's exposure;
  // 0 is a global shutter. [0, 0.9]
  double rolling_share = 0.0;

  bool IsValid(std::string* error) const;
};

// The camera's pose when the shutter opens (first row) and when it closes (last row); between them
// it moves evenly.
struct CameraMotion {
  Rigid3 world_from_camera_open;
  Rigid3 world_from_camera_close;
};

// The pose at a share (0 … 1) of the motion.
Rigid3 PoseAt(const CameraMotion& motion, double share);

// Renders images of one world by one camera. Immutable; any thread may render.
class ImageRenderer {
 public:
  // The world must outlive the renderer. Throws std::runtime_error where the camera's distortion
  // cannot be inverted.
  ImageRenderer(const World& world, const Camera& camera, const RenderOptions& options);

  // What falls on the sensor: linear RGB (CV_32FC3), with lens distortion and motion blur, without
  // vignetting. The seed moves the samples within their strata; equal seeds give equal bytes.
  // Guests stand before and behind what is there, still while the shutter is open.
  cv::Mat Render(const CameraMotion& motion, uint64_t seed,
                 const std::vector<PlacedWorld>& guests = {}) const;

  const World& world() const { return world_; }
  const Camera& camera() const { return camera_; }
  const RenderOptions& options() const { return options_; }
  const LensTable& lens() const { return lens_; }

 private:
  const World& world_;
  Camera camera_;
  RenderOptions options_;
  LensTable lens_;
};

// Depth along the optical axis (m, CV_32F; 0 where nothing is hit) at every step-th pixel from
// (step/2, step/2).
cv::Mat RenderDepth(const World& world, const Camera& camera, const Rigid3& world_from_camera,
                    int step_px);

}  // namespace rovio_sfm::sim
