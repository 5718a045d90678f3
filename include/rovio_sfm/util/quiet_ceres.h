#pragma once

#include <ceres/ceres.h>
#include <glog/logging.h>

namespace rovio_sfm {

// ceres::Solve, without what Ceres tells on the terminal of each step that fails and is tried again
// with more damping. Whether the whole failed the summary says: only that concerns who called.
inline ceres::Solver::Summary SolveQuietly(const ceres::Solver::Options& options,
                                           ceres::Problem* problem) {
  [[maybe_unused]] static const int once = FLAGS_minloglevel = google::GLOG_ERROR;
  ceres::Solver::Summary summary;
  ceres::Solve(options, problem, &summary);
  return summary;
}

}  // namespace rovio_sfm
