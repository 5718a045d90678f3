#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "rovio_sfm/app/mapping_engine.h"
#include "rovio_sfm/finish/make_grid.h"
#include "rovio_sfm/geometry/sim3.h"
#include "rovio_sfm/scene/point_cloud.h"
#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm {

// How the sessions of a map lie. Equal until the map is merged, taken apart or forgotten; a new
// scale, which moves all of it alike, changes level_from_map alone.
struct MapGauge {
  uint64_t epoch = 0;
  MapId map;
  uint32_t revision = 0;
  std::vector<SessionId> sessions;
  Sim3 level_from_map;  // not compared
};
bool operator==(const MapGauge& a, const MapGauge& b);
// Nothing where there is no such map with a frame.
std::optional<MapGauge> GaugeOf(const MapPicture& picture, MapId map);

// What was made of a map, in its level frame; null: nothing was.
struct MapProducts {
  std::shared_ptr<const PointCloud> dense;      // by depth
  std::shared_ptr<const PointCloud> densified;  // by matches
  bool is_densified_newer = false;              // than the other
  std::shared_ptr<const TriangleMesh> surface;
  std::shared_ptr<const OccupancyGridMap> grid;

  const std::shared_ptr<const PointCloud>& NewestCloud() const {
    return is_densified_newer ? densified : dense;
  }
};

// What was made of each map, as long as the map lies as it did then. Thread-safe.
class ProductShelf {
 public:
  // Adds what is not null to what was made of the map before. False, and it is not taken, where the
  // map does not lie any more as it did when the work began.
  bool Put(const MapGauge& then, const MapPicture& now, const MapProducts& made) EXCLUDES(mutex_);

  // What still holds, by map. A new scale moves points and corners along; a grid is taken back.
  std::map<MapId, MapProducts> Fitting(const MapPicture& now) EXCLUDES(mutex_);

 private:
  struct Entry {
    MapGauge gauge;
    MapProducts products;
  };

  void Fit(const MapPicture& now) REQUIRES(mutex_);

  Mutex mutex_;
  std::map<MapId, Entry> entries_ GUARDED_BY(mutex_);
};

}  // namespace rovio_sfm
