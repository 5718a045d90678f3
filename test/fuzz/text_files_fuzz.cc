// Trajectories, odometry, and the times of a data set.
#include <stdexcept>

#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_input.h"
#include "rovio_sfm/io/odometry_file.h"
#include "rovio_sfm/io/text_file.h"
#include "rovio_sfm/io/trajectory_file.h"

namespace {

template <typename Read>
void Try(const Read& read) {
  try {
    read();
  } catch (const std::runtime_error&) {  // refused, and says why
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace rovio_sfm;  // NOLINT: a fuzz target is a main
  const FuzzFile file(FuzzInput(data, size).Rest());
  Try([&] {
    const std::vector<StampedPose> poses = ReadTrajectory(file.Path());
    if (poses.size() < 2) return;
    const int64_t middle_ns = poses.front().stamp_ns / 2 + poses.back().stamp_ns / 2;
    InterpolatePose(poses, middle_ns, INT64_MAX);
    TrajectoryText(poses);
  });
  Try([&] {
    const std::vector<StampedOdometry> samples = ReadOdometry(file.Path());
    if (samples.size() < 2) return;
    const int64_t middle_ns = samples.front().stamp_ns / 2 + samples.back().stamp_ns / 2;
    InterpolateOdometry(samples, middle_ns, INT64_MAX);
  });
  return 0;
}
