#include "rovio_sfm/surface/drop_chatter.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace rovio_sfm {
namespace {

TEST(DropChatter, LetsAllElseThrough) {
  testing::internal::CaptureStdout();
  std::printf("before\n");
  {
    const DropChatter outer;
    std::printf("Vertex pair not in list 2\t[%d] (1 2 3)\n", 8);
    const DropChatter inner;
    std::printf("wrote %s\n", "mesh.ply");
    std::printf("Vertex pair not in list 1 (7) 0\t[8] (1 2 3)\n");
    std::printf("without an end");
  }
  std::printf("; Vertex pair not in list: after\n");
  std::fflush(stdout);
  EXPECT_EQ(testing::internal::GetCapturedStdout(),
            "before\nwrote mesh.ply\nwithout an end; Vertex pair not in list: after\n");
}

}  // namespace
}  // namespace rovio_sfm
