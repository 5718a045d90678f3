#include "rovio_sfm/sim/world/surface.h"

#include <cmath>
#include <map>
#include <stdexcept>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm::sim {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3d;

struct Quad {
  std::array<Vector3d, 4> corners;  // of the part
  std::array<Vector3d, 4> normals;
  std::array<Eigen::Vector2d, 4> uv_m;  // position on the face, metres
};

// Quads that share one window of the texture.
struct Face {
  std::vector<Quad> quads;
  Eigen::Vector2d size_m;
};

Face FlatFace(const Vector3d& corner, const Vector3d& along_u, const Vector3d& along_v) {
  const Vector3d normal = along_u.cross(along_v).normalized();
  Quad quad;
  quad.corners = {corner, corner + along_u, corner + along_u + along_v, corner + along_v};
  quad.normals.fill(normal);
  const double width = along_u.norm(), height = along_v.norm();
  // Rows of a texture run downwards, v upwards.
  quad.uv_m = {Eigen::Vector2d(0, height), {width, height}, {width, 0}, {0, 0}};
  return {{quad}, {width, height}};
}

std::vector<Face> BoxFaces(const Vector3d& size) {
  const Vector3d x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
  const Vector3d low = -0.5 * (x + y);
  return {FlatFace(low + x, y, z), FlatFace(low + y, -y, z), FlatFace(low + x + y, -x, z),
          FlatFace(low, x, z),     FlatFace(low + z, x, y),  FlatFace(low + y, x, -y)};
}

Face PanelFace(const Vector3d& size) {
  const Vector3d y(0, size.y(), 0), z(0, 0, size.z());
  return FlatFace(-0.5 * (y + z), y, z);
}

// The ring between two points of a lathe's profile.
Face LatheRing(const Eigen::Vector2d& low, const Eigen::Vector2d& high, int sides) {
  const double slant = (high - low).norm();
  const double radius = std::max(low.x(), high.x());
  const Eigen::Vector2d outward(high.y() - low.y(), low.x() - high.x());
  Face face;
  face.size_m = {2.0 * M_PI * radius, slant};
  for (int i = 0; i < sides; ++i) {
    const double angles[] = {2.0 * M_PI * i / sides, 2.0 * M_PI * (i + 1) / sides};
    const auto point = [&](const Eigen::Vector2d& p, double a) {
      return Vector3d(p.x() * std::cos(a), p.x() * std::sin(a), p.y());
    };
    const auto normal = [&](double a) {
      return Vector3d(outward.x() * std::cos(a), outward.x() * std::sin(a), outward.y())
          .normalized();
    };
    Quad quad;
    quad.corners = {point(low, angles[0]), point(low, angles[1]), point(high, angles[1]),
                    point(high, angles[0])};
    quad.normals = {normal(angles[0]), normal(angles[1]), normal(angles[1]), normal(angles[0])};
    quad.uv_m = {Eigen::Vector2d(radius * angles[0], slant),
                 {radius * angles[1], slant},
                 {radius * angles[1], 0},
                 {radius * angles[0], 0}};
    face.quads.push_back(quad);
  }
  return face;
}

std::vector<Face> LatheFaces(const PartSpec& part) {
  std::vector<Face> faces;
  for (size_t i = 0; i + 1 < part.profile_m.size(); ++i) {
    if ((part.profile_m[i + 1] - part.profile_m[i]).norm() < 1e-6) continue;
    faces.push_back(LatheRing(part.profile_m[i], part.profile_m[i + 1], part.sides));
  }
  return faces;
}

std::vector<Face> PartFaces(const PartSpec& part) {
  switch (part.shape) {
    case PartShape::kBox:
      return BoxFaces(part.size_m);
    case PartShape::kPanel:
      return {PanelFace(part.size_m)};
    case PartShape::kLathe:
      return LatheFaces(part);
  }
  return {};
}

// The upper left texel of a face's window, chosen by chance.
Vector2f ChooseWindow(const Face& face, const TextureSpec& texture, const std::string& object,
                      Rng& rng) {
  const double spare_x = texture.width_px - face.size_m.x() / texture.texel_m;
  const double spare_y = texture.height_px - face.size_m.y() / texture.texel_m;
  if (spare_x < 0.0 || spare_y < 0.0) {
    throw std::runtime_error("object " + object + ": a face of " + std::to_string(face.size_m.x()) +
                             " x " + std::to_string(face.size_m.y()) +
                             " m is larger than texture " + texture.name);
  }
  return {static_cast<float>(rng.Uniform(0.0, spare_x)),
          static_cast<float>(rng.Uniform(0.0, spare_y))};
}

Surface PlaceQuad(const Quad& quad, const Rigid3& world_from_part, const Vector2f& window,
                  double texel_m) {
  Surface surface;
  for (size_t i = 0; i < 4; ++i) {
    surface.corners[i] = (world_from_part * quad.corners[i]).cast<float>();
    surface.normals[i] = (world_from_part.rotation * quad.normals[i]).cast<float>();
    surface.texels[i] = window + (quad.uv_m[i] / texel_m).cast<float>();
  }
  return surface;
}

struct TexturedFace {
  Face face;
  const PartSpec* part;
  int texture, object;
  Vector2f window;
};

void PlaceFace(const TexturedFace& textured, const Rigid3& world_from_object, double texel_m,
               std::vector<Surface>* surfaces) {
  const Rigid3 world_from_part = world_from_object * textured.part->object_from_part;
  for (const Quad& quad : textured.face.quads) {
    Surface surface = PlaceQuad(quad, world_from_part, textured.window, texel_m);
    surface.texture = textured.texture;
    surface.object = textured.object;
    surface.mirror = static_cast<float>(textured.part->mirror);
    surface.gloss = static_cast<float>(textured.part->gloss);
    surface.roughness = static_cast<float>(textured.part->roughness);
    surfaces->push_back(surface);
  }
}

void PlaceObject(const WorldSpec& world, size_t index,
                 const std::map<std::string, int>& texture_index, Rng rng,
                 std::vector<Surface>* surfaces) {
  const ObjectSpec& object = world.objects[index];
  std::vector<TexturedFace> faces;
  for (const PartSpec& part : object.parts) {
    const int texture = texture_index.at(part.texture);
    for (const Face& face : PartFaces(part)) {
      const TextureSpec& spec = world.textures[static_cast<size_t>(texture)];
      faces.push_back({face, &part, texture, static_cast<int>(index),
                       ChooseWindow(face, spec, object.name, rng)});
    }
  }
  for (const Rigid3& world_from_object : object.world_from_object) {
    for (const TexturedFace& face : faces) {
      const double texel_m = world.textures[static_cast<size_t>(face.texture)].texel_m;
      PlaceFace(face, world_from_object, texel_m, surfaces);
    }
  }
}

}  // namespace

std::vector<Surface> BuildSurfaces(const WorldSpec& world) {
  std::map<std::string, int> texture_index;
  for (const TextureSpec& texture : world.textures) {
    texture_index.emplace(texture.name, static_cast<int>(texture_index.size()));
  }
  std::vector<Surface> surfaces;
  Rng rng(world.seed);
  for (size_t i = 0; i < world.objects.size(); ++i) {
    PlaceObject(world, i, texture_index, rng.Fork(surfaces.size()), &surfaces);
  }
  for (const LightSpec& light : world.lights) {
    const Face face = PanelFace({1.0, light.size_m.x(), light.size_m.y()});
    Surface lamp = PlaceQuad(face.quads.front(), light.world_from_light, {0.0f, 0.0f}, 1.0);
    lamp.texture = -1;
    lamp.emission = static_cast<float>(light.radiance);
    surfaces.push_back(lamp);
  }
  return surfaces;
}

}  // namespace rovio_sfm::sim
