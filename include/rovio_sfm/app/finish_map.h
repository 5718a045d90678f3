#pragma once

#include <optional>

#include "rovio_sfm/app/write_model_files.h"
#include "rovio_sfm/finish/densify_map.h"
#include "rovio_sfm/finish/make_dense_cloud.h"
#include "rovio_sfm/scene/point_cloud.h"

namespace rovio_sfm {

// What is made of a map after the drive: its densified cloud, its dense cloud and the surface
// through that. Each is made once, when it is first asked for, on as many threads as the machine
// has cores.
class FinishedMap {
 public:
  // All are borrowed.
  FinishedMap(const MapModel& model, const PictureSource& pictures, const ReadFeatures& features)
      : model_(model), pictures_(pictures), features_(features) {}

  // Throws as DensifyMap does.
  const DensifiedMap& Densified();

  // Throws as MakeDenseCloud does.
  const PointCloud& DenseCloud();
  const TriangleMesh& Surface();

 private:
  const MapModel& model_;
  const PictureSource& pictures_;
  const ReadFeatures& features_;
  std::optional<DensifiedMap> densified_;
  std::optional<PointCloud> cloud_;
  std::optional<TriangleMesh> surface_;
};

}  // namespace rovio_sfm
