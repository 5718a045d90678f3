#include "rovio_sfm/sim/world/texture_spec.h"

#include <gtest/gtest.h>

namespace rovio_sfm::sim {
namespace {

TEST(TextureSpec, NamesAnUnknownMark) {
  TextureSpec spec;
  spec.name = "test";
  spec.marks = {"glitter"};
  std::string error;
  EXPECT_FALSE(spec.IsValid(&error));
  EXPECT_NE(error.find("glitter"), std::string::npos);
}

TEST(TextureSpec, RefusesAHugeTexture) {
  TextureSpec spec;
  spec.name = "test";
  spec.width_px = 100000;
  std::string error;
  EXPECT_FALSE(spec.IsValid(&error));
  EXPECT_NE(error.find("width_px"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm::sim
