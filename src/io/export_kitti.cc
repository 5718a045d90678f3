#include "rovio_sfm/io/export_kitti.h"

#include "rovio_sfm/io/append_fields.h"
#include "rovio_sfm/io/text_file.h"

namespace rovio_sfm {

std::string KittiPosesText(const std::vector<StampedPose>& trajectory,
                           const Rigid3& map_from_first) {
  std::string text;
  for (const StampedPose& pose : trajectory) {
    const Rigid3 first_from_camera = Inverse(map_from_first) * pose.reference_from_body;
    const Eigen::Matrix3d rotation = first_from_camera.rotation.toRotationMatrix();
    for (int i = 0; i < 3; ++i) {
      AppendFields(&text, rotation(i, 0), rotation(i, 1), rotation(i, 2),
                   first_from_camera.translation(i));
    }
    text += "\n";
  }
  return text;
}

std::string KittiTimesText(const std::vector<StampedPose>& trajectory, int64_t first_ns) {
  std::string text;
  for (const StampedPose& pose : trajectory) {
    text += DecimalFromStamp(pose.stamp_ns - first_ns) + "\n";
  }
  return text;
}

}  // namespace rovio_sfm
