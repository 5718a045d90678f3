#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include "rovio_sfm/util/steady_clock.h"

namespace rovio_sfm {

// Publishes diagnostics once in the updater's period (~diagnostic_period, 1 s) by the steady clock:
// the updater's own pace halves where it is asked once a second, and stands still where the clock
// steps back or is simulated. Call Tick often, from one thread.
class DiagnosticPace {
 public:
  explicit DiagnosticPace(diagnostic_updater::Updater* updater) : updater_(updater) {}

  void Tick() {
    const double now_s = SteadySeconds();
    if (now_s < next_s_) return;
    next_s_ = now_s + updater_->getPeriod() - kTickS;
    updater_->force_update();
  }

 private:
  static constexpr double kTickS = 0.05;  // half of the time from one call to the next, about

  diagnostic_updater::Updater* updater_;
  double next_s_ = 0.0;
};

}  // namespace rovio_sfm
