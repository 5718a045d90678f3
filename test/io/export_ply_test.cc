#include "rovio_sfm/io/export_ply.h"

#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

#include "util/run_program.h"
#include "util/temporary_folder.h"

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

std::vector<CloudPoint> ThreePoints() {
  std::vector<CloudPoint> points(3);
  for (uint32_t i = 0; i < 3; ++i) {
    points[i].x_in_map = {1.0 + i, -0.1, 1e-7};
    points[i].color = {255, 0, 51};
  }
  return points;
}

// What Open3D finds in both kinds of file: positions and colours (0 … 1), by rows.
TEST(PlyBytes, AreReadByOpen3d) {
  const TemporaryFolder folder;
  folder.Write("binary.ply", PlyBytes(ThreePoints(), "metres"));
  folder.Write("ascii.ply", PlyText(ThreePoints(), "metres"));
  const std::string script = folder
                                 .Write("read.py", R"(
import sys, numpy, open3d
for name in ("binary.ply", "ascii.ply"):
    cloud = open3d.io.read_point_cloud(sys.argv[1] + "/" + name)
    rows = numpy.hstack([numpy.asarray(cloud.points), numpy.asarray(cloud.colors)])
    expected = [[1 + i, -0.1, 1e-7, 1, 0, 0.2] for i in range(3)]
    print(name, rows.shape, "equal" if numpy.allclose(rows, expected, atol=1e-9, rtol=1e-6) else rows)
)")
                                 .string();
  const std::string printed = RunProgram("env -u PYTHONPATH -u PYTHONHOME /usr/bin/python3 " +
                                         script + " " + folder.Path().string());
  EXPECT_NE(printed.find("binary.ply (3, 6) equal"), std::string::npos) << printed;
  EXPECT_NE(printed.find("ascii.ply (3, 6) equal"), std::string::npos) << printed;
}

TEST(PlyText, HoldsAPointALine) {
  const std::string text = PlyText(ThreePoints(), "map units");
  EXPECT_NE(text.find("format ascii 1.0\n"), std::string::npos);
  EXPECT_NE(text.find("end_header\n1 -0.1 1e-07 255 0 51 0 0 0\n2 "), std::string::npos) << text;
}

TEST(PlyBytes, WritesAnEmptyCloud) {
  EXPECT_NE(PlyBytes({}, "map units").find("element vertex 0\n"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
