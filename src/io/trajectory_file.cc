#include "rovio_sfm/io/trajectory_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "rovio_sfm/io/text_file.h"

namespace rovio_sfm {
namespace {

constexpr double kMaxNormError = 0.01;

StampedPose ParsePose(const TextLine& line) {
  line.RequireFields(8, "timestamp tx ty tz qx qy qz qw");
  StampedPose pose;
  pose.stamp_ns = line.Stamp(0, "timestamp");
  pose.reference_from_body.translation = {line.Number(1, "tx"), line.Number(2, "ty"),
                                          line.Number(3, "tz")};
  const Eigen::Quaterniond rotation(line.Number(7, "qw"), line.Number(4, "qx"),
                                    line.Number(5, "qy"), line.Number(6, "qz"));
  if (!(std::abs(rotation.norm() - 1.0) < kMaxNormError)) {
    line.Fail("fields qx qy qz qw: expected a quaternion of length 1, got length " +
              std::to_string(rotation.norm()));
  }
  pose.reference_from_body.rotation = rotation.normalized();
  return pose;
}

std::string PoseText(const Rigid3& pose) {
  const Eigen::Vector3d& t = pose.translation;
  const Eigen::Quaterniond& q = pose.rotation;
  char text[256];
  std::snprintf(text, sizeof(text), " %.9f %.9f %.9f %.9f %.9f %.9f %.9f\n", t.x(), t.y(), t.z(),
                q.x(), q.y(), q.z(), q.w());
  return text;
}

}  // namespace

std::vector<StampedPose> ReadTrajectory(const std::filesystem::path& path) {
  std::vector<StampedPose> trajectory;
  for (const TextLine& line : ReadTextFile(path)) {
    trajectory.push_back(ParsePose(line));
    const size_t count = trajectory.size();
    if (count > 1 && trajectory[count - 1].stamp_ns <= trajectory[count - 2].stamp_ns) {
      line.Fail("field timestamp: expected a later one than the line before");
    }
  }
  return trajectory;
}

std::string TrajectoryText(const std::vector<StampedPose>& trajectory) {
  std::string text = "# timestamp tx ty tz qx qy qz qw (camera to map)\n";
  for (const StampedPose& pose : trajectory) {
    text += DecimalFromStamp(pose.stamp_ns) + PoseText(pose.reference_from_body);
  }
  return text;
}

std::optional<Rigid3> InterpolatePose(const std::vector<StampedPose>& trajectory, int64_t stamp_ns,
                                      int64_t max_gap_ns) {
  const auto after = std::lower_bound(
      trajectory.begin(), trajectory.end(), stamp_ns,
      [](const StampedPose& pose, int64_t stamp) { return pose.stamp_ns < stamp; });
  if (after == trajectory.end()) return std::nullopt;
  if (after->stamp_ns == stamp_ns) return after->reference_from_body;
  if (after == trajectory.begin()) return std::nullopt;
  const auto before = std::prev(after);
  const int64_t gap_ns = after->stamp_ns - before->stamp_ns;
  if (gap_ns > max_gap_ns) return std::nullopt;
  const double share =
      static_cast<double>(stamp_ns - before->stamp_ns) / static_cast<double>(gap_ns);
  const Rigid3& a = before->reference_from_body;
  const Rigid3& b = after->reference_from_body;
  return Rigid3{a.rotation.slerp(share, b.rotation),
                (1.0 - share) * a.translation + share * b.translation};
}

}  // namespace rovio_sfm
