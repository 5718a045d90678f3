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

}  // namespace rovio_sfm
