#include "rovio_sfm/finish/measure_points.h"

#include <cmath>

#include "rovio_sfm/geometry/triangulate.h"

namespace rovio_sfm {

PointFigures MeasurePoints(const MapModel& model) {
  PointFigures figures;
  double squared = 0.0, squared_px = 0.0, num_views = 0.0;
  for (const ModelPoint& point : model.points) {
    ++figures.num_points;
    figures.num_projections += point.views.size();
    if (point.views.size() <= 3) continue;
    for (const ModelView& view : point.views) {
      const ModelImage& image = model.images[view.image];
      const Eigen::Vector2d& seen = image.keypoints[view.keypoint].x_normalized;
      const auto error = ReprojectionError(image.cam_from_map, seen, point.x_in_map);
      if (!error) continue;
      const double error_px = *error * model.cameras[image.camera].MeanFocal();
      squared += *error * *error, squared_px += error_px * error_px, num_views += 1.0;
    }
  }
  if (num_views > 0.0) {
    figures.rms_n = 1000.0 * std::sqrt(squared / (2.0 * num_views));
    figures.rms_px = std::sqrt(squared_px / (2.0 * num_views));
  }
  return figures;
}

}  // namespace rovio_sfm
