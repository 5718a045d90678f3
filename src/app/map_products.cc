#include "rovio_sfm/app/map_products.h"

#include <tuple>

#include "rovio_sfm/report/level_map.h"

namespace rovio_sfm {
namespace {

void Move(const Sim3& b_from_a, PointCloud* points) {
  const Eigen::Matrix3f rotation = b_from_a.rotation.toRotationMatrix().cast<float>();
  for (DensePoint& point : *points) {
    point.position = (b_from_a * point.position.cast<double>()).cast<float>();
    point.normal = rotation * point.normal;
  }
}

std::shared_ptr<const PointCloud> Moved(const Sim3& b_from_a,
                                        const std::shared_ptr<const PointCloud>& points) {
  if (!points) return nullptr;
  auto moved = std::make_shared<PointCloud>(*points);
  Move(b_from_a, moved.get());
  return moved;
}

MapProducts Moved(const Sim3& b_from_a, const MapProducts& products) {
  MapProducts moved;
  moved.dense = Moved(b_from_a, products.dense);
  moved.densified = Moved(b_from_a, products.densified);
  moved.is_densified_newer = products.is_densified_newer;
  if (products.surface) {
    auto surface = std::make_shared<TriangleMesh>(*products.surface);
    Move(b_from_a, &surface->vertices);
    moved.surface = std::move(surface);
  }
  return moved;
}

MapProducts MovedFromTo(const Sim3& then, const Sim3& now, const MapProducts& products) {
  return then == now ? products : Moved(now * Inverse(then), products);
}

void Add(const MapProducts& more, MapProducts* products) {
  if (more.dense) products->dense = more.dense;
  if (more.densified) products->densified = more.densified;
  if (more.dense || more.densified) products->is_densified_newer = more.densified != nullptr;
  if (more.surface) products->surface = more.surface;
  if (more.grid) products->grid = more.grid;
}

}  // namespace

bool operator==(const MapGauge& a, const MapGauge& b) {
  return std::tie(a.epoch, a.map, a.revision, a.sessions) ==
         std::tie(b.epoch, b.map, b.revision, b.sessions);
}

std::optional<MapGauge> GaugeOf(const MapPicture& picture, MapId id) {
  const std::optional<LevelMap> map = FindLevelMap(*picture.snapshot, id);
  if (!map) return std::nullopt;
  MapGauge gauge{picture.epoch, id, map->sessions.front().gauge_revision, {}, map->level_from_map};
  for (const SessionSnapshot& session : map->sessions) gauge.sessions.push_back(session.id);
  return gauge;
}

bool ProductShelf::Put(const MapGauge& then, const MapPicture& now, const MapProducts& made) {
  MutexLock lock(mutex_);
  Fit(now);
  const std::optional<MapGauge> gauge = GaugeOf(now, then.map);
  if (!gauge || !(*gauge == then)) return false;
  const MapProducts fitting = MovedFromTo(then.level_from_map, gauge->level_from_map, made);
  Entry& entry = entries_[then.map];
  entry.gauge = *gauge;
  Add(fitting, &entry.products);
  return true;
}

std::map<MapId, MapProducts> ProductShelf::Fitting(const MapPicture& now) {
  MutexLock lock(mutex_);
  Fit(now);
  std::map<MapId, MapProducts> fitting;
  for (const auto& [id, entry] : entries_) fitting[id] = entry.products;
  return fitting;
}

void ProductShelf::Fit(const MapPicture& now) {
  for (auto entry = entries_.begin(); entry != entries_.end();) {
    const std::optional<MapGauge> gauge = GaugeOf(now, entry->first);
    if (!gauge || !(*gauge == entry->second.gauge)) {
      entry = entries_.erase(entry);
      continue;
    }
    entry->second.products = MovedFromTo(entry->second.gauge.level_from_map, gauge->level_from_map,
                                         entry->second.products);
    entry->second.gauge = *gauge;
    ++entry;
  }
}

}  // namespace rovio_sfm
