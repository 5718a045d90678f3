#include "rovio_sfm/io/export_colmap_database.h"

#include <map>
#include <sstream>

#include "io/synthetic_model.h"
#include "rovio_sfm/io/export_colmap.h"

namespace rovio_sfm {
namespace {

// The positions of the points of a COLMAP text model.
std::vector<Eigen::Vector3d> ReadPoints(const std::filesystem::path& path) {
  std::vector<Eigen::Vector3d> points;
  std::istringstream file(ReadText(path));
  for (std::string line; std::getline(file, line);) {
    if (line.rfind('#', 0) == 0) continue;
    std::istringstream fields(line);
    uint64_t id = 0;
    Eigen::Vector3d x;
    fields >> id >> x.x() >> x.y() >> x.z();
    points.push_back(x);
  }
  return points;
}

double DistanceToNearest(const Eigen::Vector3d& x, const MapModel& model) {
  double distance = 1e9;
  for (const ModelPoint& point : model.points) {
    distance = std::min(distance, (point.x_in_map - x).norm());
  }
  return distance;
}

// From the poses of the model and the matches of the database alone. COLMAP triangulates nothing
// where a coefficient of the distortion (k3 = 1.16 here) is larger than max_extra_param.
TEST(ColmapDatabaseBytes, LetColmapTriangulateThePointsAnew) {
  const TemporaryFolder folder;
  const MapModel model = MakeSyntheticModel(FullCamera());
  const std::string database = folder.Write("database.db", ColmapDatabaseBytes(model)).string();
  const std::string sparse = WriteAll(ColmapBinaryFiles(model), "sparse", folder);
  const std::string out = (folder.Path() / "out").string();
  std::filesystem::create_directories(out);
  RunProgram("colmap point_triangulator --clear_points 1 --database_path " + database +
             " --image_path " + folder.Path().string() + " --input_path " + sparse +
             " --output_path " + out +
             " --Mapper.tri_ignore_two_view_tracks 0 --Mapper.max_extra_param 10");
  RunProgram("colmap model_converter --output_type TXT --input_path " + out + " --output_path " +
             out);
  const std::vector<Eigen::Vector3d> points = ReadPoints(folder.Path() / "out" / "points3D.txt");
  EXPECT_GE(points.size(), model.points.size() * 95 / 100);
  for (const Eigen::Vector3d& x : points) EXPECT_LT(DistanceToNearest(x, model), 1e-3);
}

TEST(ColmapDatabaseBytes, AreTheSameTwice) {
  const MapModel model = MakeSyntheticModel(FullCamera());
  EXPECT_EQ(ColmapDatabaseBytes(model), ColmapDatabaseBytes(model));
}

TEST(ColmapDatabaseBytes, HoldAnEmptyModel) {
  const TemporaryFolder folder;
  const auto path = folder.Write("database.db", ColmapDatabaseBytes({}));
  EXPECT_EQ(RunProgram("sqlite3 " + path.string() + " 'SELECT count(*) FROM images'"), "0\n");
}

}  // namespace
}  // namespace rovio_sfm
