#pragma once

#include <glog/logging.h>

namespace rovio_sfm {

// Ceres tells on the terminal each step that fails and is tried again with more damping. Whether
// the whole failed its summary says: only that concerns who called. Before the first Solve.
inline void QuietCeres() {
  [[maybe_unused]] static const int once = FLAGS_minloglevel = google::GLOG_ERROR;
}

}  // namespace rovio_sfm
