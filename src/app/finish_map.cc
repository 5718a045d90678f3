#include "rovio_sfm/app/finish_map.h"

#include <thread>

#include "rovio_sfm/surface/reconstruct_surface.h"

namespace rovio_sfm {

const PointCloud& FinishedMap::DenseCloud() {
  if (!cloud_) {
    Executor executor(static_cast<int>(std::thread::hardware_concurrency()));
    cloud_ = MakeDenseCloud(model_, pictures_, {}, &executor);
  }
  return *cloud_;
}

const TriangleMesh& FinishedMap::Surface() {
  if (!surface_) surface_ = ReconstructSurface(DenseCloud(), {});
  return *surface_;
}

}  // namespace rovio_sfm
