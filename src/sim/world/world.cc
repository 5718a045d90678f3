#include "rovio_sfm/sim/world/world.h"

#include <algorithm>
#include <cmath>

#include "rovio_sfm/sim/world/draw_texture.h"

namespace rovio_sfm::sim {
namespace {

using Eigen::Vector3f;

std::vector<Texture> DrawTextures(const WorldSpec& spec) {
  std::vector<Texture> textures;
  for (const TextureSpec& texture : spec.textures) {
    textures.emplace_back(DrawTexture(texture), texture.texel_m);
  }
  return textures;
}

// Schlick's approximation: reflections grow towards grazing angles.
float ReflectedShare(const Surface& surface, float cosine) {
  const float rest = 1.0f - cosine;
  const float grazing = rest * rest * rest * rest * rest;
  const float glossy = surface.gloss * (0.04f + 0.96f * grazing);
  return std::clamp(surface.mirror + (1.0f - surface.mirror) * glossy, 0.0f, 1.0f);
}

Vector3f Reflect(const Vector3f& direction, const Vector3f& normal, float roughness,
                 const Eigen::Vector2f& chance) {
  const Vector3f mirrored = direction - 2.0f * direction.dot(normal) * normal;
  const Vector3f side = mirrored.unitOrthogonal();
  const float radius = roughness * std::sqrt(chance.x());
  const float angle = 2.0f * static_cast<float>(M_PI) * chance.y();
  return (mirrored + radius * std::cos(angle) * side +
          radius * std::sin(angle) * mirrored.cross(side))
      .normalized();
}

}  // namespace

World::World(const WorldSpec& spec)
    : spec_(spec),
      surfaces_(BuildSurfaces(spec_)),
      textures_(DrawTextures(spec_)),
      scene_(surfaces_),
      light_maps_(BakeLight(spec_, surfaces_, scene_)) {}

Vector3f World::Diffuse(const Vector3f& direction, const RayHit& hit, float spread_rad,
                        float chance) const {
  if (hit.surface < 0) return Vector3f::Zero();
  const size_t index = static_cast<size_t>(hit.surface);
  const Surface& surface = surfaces_[index];
  if (surface.texture < 0) return Vector3f::Constant(surface.emission);
  const Texture& texture = textures_[static_cast<size_t>(surface.texture)];
  const Eigen::Vector2f texel = Interpolate(surface.texels, hit.u, hit.v);
  const float cosine = std::max(std::abs(direction.dot(surface.normals[0])), 0.1f);
  const float footprint =
      spread_rad * hit.distance / (static_cast<float>(texture.texel_m()) * std::sqrt(cosine));
  return light_maps_[index].Sample(hit.u, hit.v) *
         texture.Sample(texel.x(), texel.y(), footprint, chance);
}

Vector3f World::Radiance(const Vector3f& origin, const Vector3f& direction, const RayHit& hit,
                         float spread_rad, const Eigen::Vector2f& chance) const {
  const Vector3f diffuse = Diffuse(direction, hit, spread_rad, chance.x());
  if (hit.surface < 0) return diffuse;
  const Surface& surface = surfaces_[static_cast<size_t>(hit.surface)];
  if (surface.mirror <= 0.0f && surface.gloss <= 0.0f) return diffuse;
  Vector3f normal = Interpolate(surface.normals, hit.u, hit.v).normalized();
  if (normal.dot(direction) > 0.0f) normal = -normal;
  const float share = ReflectedShare(surface, -normal.dot(direction));
  const Vector3f point = origin + hit.distance * direction;
  const Vector3f reflected = Reflect(direction, normal, surface.roughness, chance);
  RayHit next = scene_.Trace(point, reflected);
  next.distance += hit.distance;
  // Lamps in reflections are dimmed, or their few bright samples would sparkle.
  const Vector3f mirrored = Diffuse(reflected, next, spread_rad, chance.x()).cwiseMin(1.5f);
  return (1.0f - share) * diffuse + share * mirrored;
}

}  // namespace rovio_sfm::sim
