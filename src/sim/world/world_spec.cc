#include "rovio_sfm/sim/world/world_spec.h"

#include <cmath>
#include <set>
#include <utility>

#include "rovio_sfm/util/option_checker.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm::sim {
namespace {

void CheckPart(const PartSpec& part, const std::set<std::string>& textures, OptionChecker* check) {
  check->True(("texture " + part.texture).c_str(), textures.count(part.texture) == 1,
              "the name of a texture");
  check->Range("mirror", part.mirror, 0.0, 1.0);
  check->Range("gloss", part.gloss, 0.0, 1.0);
  check->Range("roughness", part.roughness, 0.0, 0.5);
  for (int axis = 0; axis < 3; ++axis) check->Range("size_m", part.size_m[axis], 1e-4, 100.0);
  if (part.shape != PartShape::kLathe) return;
  check->True("sides", part.sides >= 6 && part.sides <= 64 && part.sides % 2 == 0,
              "an even number, 6 to 64");
  check->True("profile_m", part.profile_m.size() >= 2 && part.profile_m.size() <= 100,
              "2 to 100 points");
  for (const Eigen::Vector2d& point : part.profile_m) {
    check->Range("radius of profile_m", point.x(), 0.0, 10.0);
    check->Range("z of profile_m", point.y(), -100.0, 100.0);
  }
}

}  // namespace

bool WorldSpec::IsValid(std::string* error) const {
  OptionChecker check("world " + name, error);
  check.Range("ambient", ambient, 0.0, 10.0);
  check.Range("light_cell_m", light_cell_m, 0.01, 10.0);
  check.True("textures", !textures.empty() && textures.size() <= 200, "1 to 200");
  check.True("lights", lights.size() <= 50, "at most 50");
  check.True("objects", !objects.empty() && objects.size() <= 5000, "1 to 5000");
  for (const LightSpec& light : lights) {
    check.Range("size_m of a light", light.size_m.minCoeff(), 0.01, 100.0);
    check.Range("size_m of a light", light.size_m.maxCoeff(), 0.01, 100.0);
    check.Range("radiance", light.radiance, 0.0, 10000.0);
  }
  std::set<std::string> names;
  for (const TextureSpec& texture : textures) {
    check.Nested(texture);
    check.True(("texture " + texture.name).c_str(), names.insert(texture.name).second,
               "a name used once");
  }
  for (const ObjectSpec& object : objects) {
    OptionChecker object_check("object " + object.name, check.Passed() ? error : nullptr);
    object_check.True("parts", !object.parts.empty(), "at least one");
    object_check.True("placements", !object.world_from_object.empty(), "at least one");
    for (const PartSpec& part : object.parts) CheckPart(part, names, &object_check);
    if (!object_check.Passed()) return false;
  }
  return check.Passed();
}

WorldSpec InLight(WorldSpec spec, uint64_t time_of_day) {
  if (time_of_day == 0) return spec;
  Rng rng(time_of_day ^ 0x6c69676874ULL);
  spec.ambient *= std::exp2(rng.Uniform(-0.5, 0.5));
  for (LightSpec& light : spec.lights) light.radiance *= std::exp2(rng.Uniform(-1.0, 1.0));
  return spec;
}

}  // namespace rovio_sfm::sim
