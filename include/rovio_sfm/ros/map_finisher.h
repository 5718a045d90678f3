#pragma once

#include <rovio_sfm/DensifyGoal.h>
#include <rovio_sfm/DensifyResult.h>
#include <rovio_sfm/ReconstructSurfaceGoal.h>
#include <rovio_sfm/ReconstructSurfaceResult.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "rovio_sfm/app/map_products.h"
#include "rovio_sfm/ros/kept_frames.h"
#include "rovio_sfm/ros/taken_map.h"

namespace rovio_sfm {

// What a node gives to the work on its maps. All are called by the thread of that work.
struct FinishSources {
  std::function<TakenMap(uint32_t session)> take;  // waits for mapping's thread
  std::function<MapPicture()> picture;             // of now
  std::function<KeptFrames()> frames;
  std::string output_dir;  // empty: no file may be asked for
};

// Told after each step of a stage; false ends the work for a goal.
using GoalProgress =
    std::function<bool(const std::string& stage, size_t num_done, size_t num_total)>;

// Does what goals of Densify and ReconstructSurface ask for, and puts what it made on the shelf.
// What was made of a map that was merged, taken apart or forgotten meanwhile is refused. Never
// throws; the status says what went wrong. For one thread, which waits for the work.
class MapFinisher {
 public:
  MapFinisher(FinishSources sources, ProductShelf* shelf)
      : sources_(std::move(sources)), shelf_(shelf) {}

  DensifyResult Densify(const DensifyGoal& goal, const GoalProgress& progress);
  ReconstructSurfaceResult ReconstructSurface(const ReconstructSurfaceGoal& goal,
                                              const GoalProgress& progress);
  // The grid of the root map, once that is metric; with the dense cloud, where there is one.
  void MakeRootGrid();

 private:
  using CloudPtr = std::shared_ptr<const PointCloud>;
  enum class CloudKind { kDense, kDensified };
  class Watch;

  // Each null where the watch ended it, then or before.
  CloudPtr MakeCloud(CloudKind kind, const TakenMap& taken, Watch* watch);
  std::shared_ptr<const TriangleMesh> MakeSurface(const TakenMap& taken, const PointCloud& cloud,
                                                  Watch* watch);
  CloudPtr CloudFor(const std::string& source, const TakenMap& taken, Watch* watch);
  CloudPtr KeptCloud(CloudKind kind, const TakenMap& taken);
  bool Keep(const TakenMap& taken, const MapProducts& made, Watch* watch);  // false: it has ended
  void KeepGrid(const TakenMap& taken);

  const FinishSources sources_;
  ProductShelf* const shelf_;
};

}  // namespace rovio_sfm
