#include "rovio_sfm/sim/world/light_map.h"

#include <algorithm>
#include <cmath>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm::sim {
namespace {

using Eigen::Vector3f;

constexpr int kNearStrata = 4;  // shadow rays of a near light: this squared
constexpr int kFarStrata = 2;
constexpr float kFar = 2.0f;  // a light is far beyond this many times its size
constexpr int kAmbientRays = 16;
constexpr float kAmbientReach_m = 0.8f;
constexpr float kLift_m = 2e-3f;  // off the surface

struct Point {
  Vector3f position;
  Vector3f normal;
};

// Far lights cast sharper shadows, so fewer rays will do.
int StrataOf(const LightSpec& light, const Point& point) {
  const float distance = (light.world_from_light.translation.cast<float>() - point.position).norm();
  return distance > kFar * static_cast<float>(light.size_m.maxCoeff()) ? kFarStrata : kNearStrata;
}

// False where the light lies wholly behind the surface, or the surface behind the light.
bool CanShineOn(const LightSpec& light, const Point& point) {
  const Vector3f facing =
      (light.world_from_light.rotation * Eigen::Vector3d::UnitX()).cast<float>();
  const Vector3f way = light.world_from_light.translation.cast<float>() - point.position;
  const float reach = 0.5f * static_cast<float>(light.size_m.norm());
  return way.dot(point.normal) > -reach && way.dot(facing) < 0.0f;
}

// The irradiance / pi of one rectangular light at a point, with soft shadow.
float DirectLight(const LightSpec& light, const Point& point, const RayScene& scene, Rng* rng) {
  if (!CanShineOn(light, point)) return 0.0f;
  const Rigid3& pose = light.world_from_light;
  const Vector3f facing = (pose.rotation * Eigen::Vector3d::UnitX()).cast<float>();
  const double area = light.size_m.x() * light.size_m.y();
  const int strata = StrataOf(light, point);
  float sum = 0.0f;
  for (int i = 0; i < strata * strata; ++i) {
    const double y = ((i % strata) + rng->Uniform()) / strata - 0.5;
    const double z = ((i / strata) + rng->Uniform()) / strata - 0.5;
    const Vector3f on_light =
        (pose * Eigen::Vector3d(0.005, y * light.size_m.x(), z * light.size_m.y())).cast<float>();
    const Vector3f way = on_light - point.position;
    const float squared = way.squaredNorm();
    const Vector3f direction = way / std::sqrt(squared);
    const float cosines =
        std::max(0.0f, point.normal.dot(direction)) * std::max(0.0f, -facing.dot(direction));
    if (cosines <= 0.0f || scene.IsBlocked(point.position, on_light)) continue;
    sum += cosines / std::max(squared, 1e-3f);
  }
  return static_cast<float>(light.radiance * area / M_PI) * sum /
         static_cast<float>(strata * strata);
}

// The share of the hemisphere (weighted by the cosine) that is open.
float OpenSky(const Point& point, const RayScene& scene) {
  const Vector3f side = point.normal.unitOrthogonal();
  const Vector3f other = point.normal.cross(side);
  int open = 0;
  for (int i = 0; i < kAmbientRays; ++i) {
    const float share = (static_cast<float>(i) + 0.5f) / static_cast<float>(kAmbientRays);
    const float radius = std::sqrt(share);
    const float angle = 2.39996f * static_cast<float>(i);
    const Vector3f direction = radius * std::cos(angle) * side + radius * std::sin(angle) * other +
                               std::sqrt(1.0f - share) * point.normal;
    if (!scene.IsBlocked(point.position, direction, kAmbientReach_m)) ++open;
  }
  return static_cast<float>(open) / static_cast<float>(kAmbientRays);
}

int CountCells(float length_m, double cell_m) {
  return std::clamp(static_cast<int>(std::ceil(length_m / cell_m)) + 1, 2, 400);
}

LightMap BakeSurface(const WorldSpec& world, const Surface& surface, const RayScene& scene,
                     Rng rng) {
  const auto& c = surface.corners;
  LightMap map;
  map.cols = CountCells(std::max((c[1] - c[0]).norm(), (c[2] - c[3]).norm()), world.light_cell_m);
  map.rows = CountCells(std::max((c[3] - c[0]).norm(), (c[2] - c[1]).norm()), world.light_cell_m);
  for (int row = 0; row < map.rows; ++row) {
    for (int col = 0; col < map.cols; ++col) {
      // The outermost points lie a little inside, or they would meet the neighbouring wall.
      const float u =
          std::clamp(static_cast<float>(col) / static_cast<float>(map.cols - 1), 0.02f, 0.98f);
      const float v =
          std::clamp(static_cast<float>(row) / static_cast<float>(map.rows - 1), 0.02f, 0.98f);
      Point point;
      point.normal = Interpolate(surface.normals, u, v).normalized();
      point.position = Interpolate(c, u, v) + kLift_m * point.normal;
      float light = static_cast<float>(world.ambient) * (0.3f + 0.7f * OpenSky(point, scene));
      for (const LightSpec& lamp : world.lights) light += DirectLight(lamp, point, scene, &rng);
      map.irradiance.push_back(light);
    }
  }
  return map;
}

}  // namespace

float LightMap::Sample(float u, float v) const {
  const float x = std::clamp(u, 0.0f, 1.0f) * static_cast<float>(cols - 1);
  const float y = std::clamp(v, 0.0f, 1.0f) * static_cast<float>(rows - 1);
  const int x0 = std::min(static_cast<int>(x), cols - 2),
            y0 = std::min(static_cast<int>(y), rows - 2);
  const float a = x - static_cast<float>(x0), b = y - static_cast<float>(y0);
  const float* p = irradiance.data() + static_cast<ptrdiff_t>(y0) * cols + x0;
  return (1 - b) * ((1 - a) * p[0] + a * p[1]) + b * ((1 - a) * p[cols] + a * p[cols + 1]);
}

std::vector<LightMap> BakeLight(const WorldSpec& world, const std::vector<Surface>& surfaces,
                                const RayScene& scene) {
  std::vector<LightMap> maps;
  Rng rng(world.seed ^ 0x6c69676874ULL);
  for (const Surface& surface : surfaces) {
    maps.push_back(BakeSurface(world, surface, scene, rng.Fork(maps.size())));
  }
  return maps;
}

}  // namespace rovio_sfm::sim
