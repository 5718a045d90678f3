#include "rovio_sfm/io/export_ply.h"

#include <cstring>

namespace rovio_sfm {
namespace {

// The hosts of ROS are little-endian, as the file is.
template <typename T>
void Append(T value, std::string* bytes) {
  char buffer[sizeof(T)];
  std::memcpy(buffer, &value, sizeof(T));
  bytes->append(buffer, sizeof(T));
}

std::string Header(size_t count, const std::string& length_unit) {
  return "ply\nformat binary_little_endian 1.0\ncomment rovio_sfm, lengths in " + length_unit +
         "\nelement vertex " + std::to_string(count) +
         "\nproperty float x\nproperty float y\nproperty float z\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\n"
         "property uint session\nproperty uint views\nproperty float error\nend_header\n";
}

}  // namespace

std::string PlyBytes(const std::vector<CloudPoint>& points, const std::string& length_unit) {
  std::string bytes = Header(points.size(), length_unit);
  for (const CloudPoint& point : points) {
    for (int i = 0; i < 3; ++i) Append(static_cast<float>(point.x_in_map(i)), &bytes);
    for (const uint8_t channel : point.color) Append(channel, &bytes);
    Append(point.session, &bytes);
    Append(point.num_views, &bytes);
    Append(point.error_px, &bytes);
  }
  return bytes;
}

}  // namespace rovio_sfm
