#pragma once

#include <functional>
#include <future>
#include <memory>
#include <utility>

#include "rovio_sfm/util/lane_worker.h"

namespace rovio_sfm {

using Job = std::function<void()>;
using JobWorker = LaneWorker<Job>;

// Runs a job on a node's worker and waits for it; false if its lane refused or dropped it, or the
// worker is closed. Not from the worker's own thread.
inline bool RunAndWait(Job job, size_t lane, JobWorker* worker) {
  auto task = std::make_shared<std::packaged_task<void()>>(std::move(job));
  std::future<void> done = task->get_future();
  if (!worker->Push(lane, [task] { (*task)(); })) return false;
  task.reset();  // so that a dropped job breaks its promise
  try {
    done.get();
    return true;
  } catch (const std::future_error&) {
    return false;
  }
}

}  // namespace rovio_sfm
