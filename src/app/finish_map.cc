#include "rovio_sfm/app/finish_map.h"

#include <thread>

#include "rovio_sfm/surface/reconstruct_surface.h"

namespace rovio_sfm {

namespace {

int NumCores() { return static_cast<int>(std::thread::hardware_concurrency()); }

}  // namespace

const DensifiedMap& FinishedMap::Densified() {
  if (!densified_) {
    Executor executor(NumCores());
    densified_ = DensifyMap(model_, features_, pictures_, {}, &executor);
  }
  return *densified_;
}

const PointCloud& FinishedMap::DenseCloud() {
  if (!cloud_) {
    Executor executor(NumCores());
    cloud_ = MakeDenseCloud(model_, pictures_, {}, &executor);
  }
  return *cloud_;
}

const TriangleMesh& FinishedMap::Surface() {
  if (!surface_) surface_ = ReconstructSurface(DenseCloud(), {});
  return *surface_;
}

}  // namespace rovio_sfm
