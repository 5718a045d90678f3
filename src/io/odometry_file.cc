#include "rovio_sfm/io/odometry_file.h"

#include <algorithm>
#include <cmath>

#include "rovio_sfm/io/text_file.h"

namespace rovio_sfm {
namespace {

constexpr size_t kNumPoseFields = 4;

OdometryCovariance ParseCovariance(const TextLine& line) {
  OdometryCovariance covariance;
  for (size_t i = 0; i < 9; ++i) covariance[i] = line.Number(kNumPoseFields + i, "covariance");
  for (const size_t diagonal : {0u, 4u, 8u}) {
    if (covariance[diagonal] < 0.0) line.Fail("field covariance: negative variance");
  }
  return covariance;
}

StampedOdometry ParseOdometry(const TextLine& line) {
  const bool knows_covariance = line.fields.size() != kNumPoseFields;
  if (knows_covariance)
    line.RequireFields(13, "timestamp x y theta, covariance 3x3 by rows or none");
  StampedOdometry odometry;
  odometry.stamp_ns = line.Stamp(0, "timestamp");
  odometry.sample.x_m = line.Number(1, "x");
  odometry.sample.y_m = line.Number(2, "y");
  odometry.sample.yaw_rad = line.Number(3, "theta");
  if (knows_covariance) odometry.sample.covariance = ParseCovariance(line);
  return odometry;
}

OdometrySample Mix(const OdometrySample& a, const OdometrySample& b, double share) {
  OdometrySample mix;
  mix.x_m = (1.0 - share) * a.x_m + share * b.x_m;
  mix.y_m = (1.0 - share) * a.y_m + share * b.y_m;
  mix.yaw_rad = a.yaw_rad + share * std::remainder(b.yaw_rad - a.yaw_rad, 2.0 * M_PI);
  if (!a.covariance || !b.covariance) return mix;
  mix.covariance.emplace();
  for (size_t i = 0; i < 9; ++i) {
    (*mix.covariance)[i] = (1.0 - share) * (*a.covariance)[i] + share * (*b.covariance)[i];
  }
  return mix;
}

}  // namespace

std::vector<StampedOdometry> ReadOdometry(const std::filesystem::path& path) {
  std::vector<StampedOdometry> odometry;
  for (const TextLine& line : ReadTextFile(path)) {
    odometry.push_back(ParseOdometry(line));
    const size_t count = odometry.size();
    if (count > 1 && odometry[count - 1].stamp_ns <= odometry[count - 2].stamp_ns) {
      line.Fail("field timestamp: expected a later one than the line before");
    }
  }
  return odometry;
}

std::optional<OdometrySample> InterpolateOdometry(const std::vector<StampedOdometry>& odometry,
                                                  int64_t stamp_ns, int64_t max_gap_ns) {
  const auto after = std::lower_bound(
      odometry.begin(), odometry.end(), stamp_ns,
      [](const StampedOdometry& entry, int64_t stamp) { return entry.stamp_ns < stamp; });
  if (after == odometry.end()) return std::nullopt;
  if (after->stamp_ns == stamp_ns) return after->sample;
  if (after == odometry.begin()) return std::nullopt;
  const auto before = std::prev(after);
  const int64_t gap_ns = after->stamp_ns - before->stamp_ns;
  if (gap_ns > max_gap_ns) return std::nullopt;
  return Mix(before->sample, after->sample,
             static_cast<double>(stamp_ns - before->stamp_ns) / static_cast<double>(gap_ns));
}

}  // namespace rovio_sfm
