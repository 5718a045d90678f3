#pragma once

#include <optional>

#include "rovio_sfm/app/write_model_files.h"
#include "rovio_sfm/finish/make_dense_cloud.h"
#include "rovio_sfm/scene/point_cloud.h"

namespace rovio_sfm {

// What takes the pictures of a map to make: its dense cloud and the surface through it. Each is
// made once, when it is first asked for, on as many threads as the machine has cores.
class FinishedMap {
 public:
  // Both are borrowed.
  FinishedMap(const MapModel& model, const PictureSource& pictures)
      : model_(model), pictures_(pictures) {}

  // Throws as MakeDenseCloud does.
  const PointCloud& DenseCloud();
  const TriangleMesh& Surface();

 private:
  const MapModel& model_;
  const PictureSource& pictures_;
  std::optional<PointCloud> cloud_;
  std::optional<TriangleMesh> surface_;
};

}  // namespace rovio_sfm
