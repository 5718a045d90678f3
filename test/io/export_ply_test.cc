#include "rovio_sfm/io/export_ply.h"

#include <gtest/gtest.h>

#include <cstring>

namespace rovio_sfm {
namespace {

TEST(PlyBytes, HoldsEveryPropertyOfAPoint) {
  CloudPoint point;
  point.x_in_map = {1.0, 2.0, -3.5};
  point.color = {10, 20, 30};
  point.session = 4;
  point.num_views = 5;
  point.error_px = 0.25f;
  const std::string bytes = PlyBytes({point}, "metres");
  const size_t body = bytes.find("end_header\n") + 11;
  ASSERT_EQ(bytes.size() - body, 27u);
  float z = 0.0f, error = 0.0f;
  uint32_t session = 0;
  std::memcpy(&z, bytes.data() + body + 8, 4);
  std::memcpy(&session, bytes.data() + body + 15, 4);
  std::memcpy(&error, bytes.data() + body + 23, 4);
  EXPECT_EQ(z, -3.5f);
  EXPECT_EQ(static_cast<uint8_t>(bytes[body + 13]), 20);
  EXPECT_EQ(session, 4u);
  EXPECT_EQ(error, 0.25f);
  EXPECT_NE(bytes.find("lengths in metres"), std::string::npos);
}

TEST(PlyBytes, WritesAnEmptyCloud) {
  EXPECT_NE(PlyBytes({}, "map units").find("element vertex 0\n"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
