#include "rovio_sfm/io/export_ply.h"

#include "rovio_sfm/io/append_fields.h"

namespace rovio_sfm {
namespace {

std::string Header(const std::string& format, size_t count, const std::string& length_unit) {
  return "ply\nformat " + format + " 1.0\ncomment rovio_sfm, lengths in " + length_unit +
         "\nelement vertex " + std::to_string(count) +
         "\nproperty float x\nproperty float y\nproperty float z\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\n"
         "property uint session\nproperty uint views\nproperty float error\nend_header\n";
}

// x y z nx ny nz red green blue; what follows is the caller's.
std::string DenseHeader(size_t count, const std::string& length_unit) {
  return "ply\nformat binary_little_endian 1.0\ncomment rovio_sfm, lengths in " + length_unit +
         "\nelement vertex " + std::to_string(count) +
         "\nproperty float x\nproperty float y\nproperty float z\n"
         "property float nx\nproperty float ny\nproperty float nz\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\n";
}

void AppendDensePoint(const DensePoint& point, std::string* bytes) {
  for (const float x : point.position) AppendBytes(x, bytes);
  for (const float x : point.normal) AppendBytes(x, bytes);
  for (const uint8_t channel : point.color) AppendBytes(channel, bytes);
}

}  // namespace

std::string PlyBytes(const std::vector<CloudPoint>& points, const std::string& length_unit) {
  std::string bytes = Header("binary_little_endian", points.size(), length_unit);
  for (const CloudPoint& point : points) {
    for (int i = 0; i < 3; ++i) AppendBytes(static_cast<float>(point.x_in_map(i)), &bytes);
    for (const uint8_t channel : point.color) AppendBytes(channel, &bytes);
    AppendBytes(point.session, &bytes);
    AppendBytes(point.num_views, &bytes);
    AppendBytes(point.error_px, &bytes);
  }
  return bytes;
}

std::string PlyText(const std::vector<CloudPoint>& points, const std::string& length_unit) {
  std::string text = Header("ascii", points.size(), length_unit);
  for (const CloudPoint& point : points) {
    const Eigen::Vector3f x = point.x_in_map.cast<float>();
    AppendFields(&text, x.x(), x.y(), x.z());
    for (const int channel : point.color) AppendFields(&text, channel);
    AppendFields(&text, point.session, point.num_views, point.error_px);
    text += "\n";
  }
  return text;
}

std::string DensePlyBytes(const PointCloud& cloud, const std::string& length_unit) {
  std::string bytes = DenseHeader(cloud.size(), length_unit) + "property uint views\nend_header\n";
  for (const DensePoint& point : cloud) {
    AppendDensePoint(point, &bytes);
    AppendBytes(point.num_views, &bytes);
  }
  return bytes;
}

std::string MeshPlyBytes(const TriangleMesh& mesh, const std::string& length_unit) {
  std::string bytes = DenseHeader(mesh.vertices.size(), length_unit) + "element face " +
                      std::to_string(mesh.triangles.size()) +
                      "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const DensePoint& corner : mesh.vertices) AppendDensePoint(corner, &bytes);
  for (const auto& triangle : mesh.triangles) {
    AppendBytes(uint8_t{3}, &bytes);
    for (const uint32_t corner : triangle) AppendBytes(static_cast<int32_t>(corner), &bytes);
  }
  return bytes;
}

}  // namespace rovio_sfm
