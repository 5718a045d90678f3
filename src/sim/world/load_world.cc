#include "rovio_sfm/sim/world/load_world.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "rovio_sfm/sim/world/read_placement.h"
#include "rovio_sfm/util/load_document.h"

namespace rovio_sfm::sim {
namespace {

constexpr size_t kMaxFileBytes = 4 << 20;

cv::Vec3b Color(YamlMap* map, const std::string& key, const cv::Vec3b& fallback) {
  if (!map->Has(key)) return fallback;
  const std::vector<double> rgb = map->Numbers(key, 3);
  return {cv::saturate_cast<uint8_t>(rgb[0]), cv::saturate_cast<uint8_t>(rgb[1]),
          cv::saturate_cast<uint8_t>(rgb[2])};
}

TextureSpec ReadTexture(YamlMap map, uint64_t world_seed, size_t index) {
  TextureSpec spec;
  spec.name = map.Text("name");
  spec.seed = map.Seed("seed", world_seed * 1000 + index);
  const std::vector<double> size_px = map.Numbers("size_px", 2);
  spec.width_px = static_cast<int>(std::min(std::max(size_px[0], 0.0), 1e6));
  spec.height_px = static_cast<int>(std::min(std::max(size_px[1], 0.0), 1e6));
  spec.texel_m = 0.001 * map.Number("texel_mm");
  spec.color = Color(&map, "color", spec.color);
  spec.accent = Color(&map, "accent", spec.accent);
  spec.contrast = map.Number("contrast", spec.contrast);
  spec.stretch = map.Number("stretch", spec.stretch);
  spec.patches = map.Number("patches", spec.patches);
  spec.marks = map.Texts("marks");
  spec.density = map.Number("density", spec.density);
  spec.period_px = map.Number("period_px", spec.period_px);
  map.RefuseUnknownKeys();
  return spec;
}

LightSpec ReadLight(YamlMap map) {
  LightSpec spec;
  spec.world_from_light = ReadPlacement(&map);
  const std::vector<double> size_m = map.Numbers("size_m", 2);
  spec.size_m = {size_m[0], size_m[1]};
  spec.radiance = map.Number("radiance");
  map.RefuseUnknownKeys();
  return spec;
}

void ReadShape(YamlMap* map, PartSpec* part) {
  const std::string shape = map->Text("shape");
  if (shape == "lathe") {
    part->shape = PartShape::kLathe;
    for (const std::vector<double>& row : map->Rows("profile_m", 2)) {
      part->profile_m.emplace_back(row[0], row[1]);
    }
    part->sides = map->Integer("sides", part->sides);
  } else if (shape == "box") {
    part->shape = PartShape::kBox;
    const std::vector<double> size_m = map->Numbers("size_m", 3);
    part->size_m = {size_m[0], size_m[1], size_m[2]};
  } else if (shape == "panel") {
    part->shape = PartShape::kPanel;
    const std::vector<double> size_m = map->Numbers("size_m", 2);
    part->size_m = {1.0, size_m[0], size_m[1]};
  } else {
    map->Fail("shape", "expected box, lathe or panel");
  }
}

PartSpec ReadPart(YamlMap map) {
  PartSpec part;
  ReadShape(&map, &part);
  part.object_from_part = ReadPlacement(&map);
  part.texture = map.Text("texture");
  part.mirror = map.Number("mirror", part.mirror);
  part.gloss = map.Number("gloss", part.gloss);
  part.roughness = map.Number("roughness", part.roughness);
  map.RefuseUnknownKeys();
  return part;
}

ObjectSpec ReadObject(YamlMap map) {
  ObjectSpec object;
  object.name = map.Text("name");
  for (const YamlMap& part : map.List("parts")) object.parts.push_back(ReadPart(part));
  for (YamlMap& placement : map.List("placements")) {
    object.world_from_object.push_back(ReadPlacement(&placement));
    placement.RefuseUnknownKeys();
  }
  map.RefuseUnknownKeys();
  return object;
}

}  // namespace

WorldSpec ParseWorld(const std::string& yaml, const std::string& source) {
  if (yaml.size() > kMaxFileBytes) throw std::runtime_error(source + ": larger than 4 MiB");
  try {
    YamlMap map(LoadDocument(yaml), source, ": ");
    WorldSpec world;
    world.name = map.Text("name");
    world.seed = map.Seed("seed", 0);
    world.ambient = map.Number("ambient", world.ambient);
    world.light_cell_m = map.Number("light_cell_m", world.light_cell_m);
    for (const YamlMap& texture : map.List("textures")) {
      world.textures.push_back(ReadTexture(texture, world.seed, world.textures.size()));
    }
    for (const YamlMap& light : map.List("lights")) world.lights.push_back(ReadLight(light));
    for (const YamlMap& object : map.List("objects")) world.objects.push_back(ReadObject(object));
    map.RefuseUnknownKeys();
    std::string error;
    if (!world.IsValid(&error)) throw std::runtime_error(source + ": " + error);
    return world;
  } catch (const YAML::Exception& exception) {
    throw std::runtime_error(source + ": " + exception.what());
  }
}

WorldSpec LoadWorld(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  std::ostringstream text;
  text << file.rdbuf();
  return ParseWorld(text.str(), path);
}

}  // namespace rovio_sfm::sim
