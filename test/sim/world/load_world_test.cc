#include "rovio_sfm/sim/world/load_world.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "rovio_sfm/util/rng.h"
#include "sim/world/small_world.h"

namespace rovio_sfm::sim {
namespace {

std::string ErrorOf(const std::string& yaml) {
  try {
    ParseWorld(yaml, "file");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(ParseWorld, ReadsTheSmallWorld) {
  const WorldSpec world = SmallWorldSpec();
  EXPECT_EQ(world.name, "small");
  EXPECT_EQ(world.textures.size(), 2u);
  EXPECT_EQ(world.objects[1].world_from_object.size(), 2u);
  EXPECT_DOUBLE_EQ(world.textures[1].texel_m, 0.005);
}

TEST(ParseWorld, NamesAnUnknownShape) {
  std::string yaml = SmallWorldYaml();
  yaml.replace(yaml.find("shape: box"), 10, "shape: egg");
  EXPECT_NE(ErrorOf(yaml).find("expected box, lathe or panel"), std::string::npos);
}

TEST(ParseWorld, RefusesBrokenYamlWithASentence) {
  EXPECT_NE(ErrorOf("name: [").find("file"), std::string::npos);
  EXPECT_NE(ErrorOf("").find("file"), std::string::npos);
  EXPECT_NE(ErrorOf("- 1\n- 2").find("expected a mapping"), std::string::npos);
}

TEST(ParseWorld, SurvivesMutatedFiles) {
  Rng rng(11);
  for (int round = 0; round < 100; ++round) {
    std::string yaml = SmallWorldYaml();
    for (int i = 0; i < 4; ++i) {
      yaml[rng.UniformInt(static_cast<uint32_t>(yaml.size()))] =
          static_cast<char>(32 + rng.UniformInt(95));
    }
    yaml.resize(yaml.size() - rng.UniformInt(40));
    try {
      EXPECT_TRUE(ParseWorld(yaml, "file").IsValid(nullptr));
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("file"), std::string::npos);
    }
  }
}

TEST(LoadWorld, NamesAFileThatIsNotThere) {
  EXPECT_THROW(LoadWorld("/nowhere/world.yaml"), std::runtime_error);
}

TEST(LoadWorld, EveryShippedWorldIsValid) {
  for (const char* name : {"laboratory", "engine_room", "repeats_a", "repeats_b"}) {
    const WorldSpec world =
        LoadWorld(std::string(ROVIO_SOURCE_DIR "/config/worlds/") + name + ".yaml");
    EXPECT_EQ(world.name, name);
    EXPECT_NO_THROW(BuildSurfaces(world));
  }
}

}  // namespace
}  // namespace rovio_sfm::sim
