#pragma once

#include <cstdint>
#include <string>

#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

struct BackOffOptions {
  double first_delay_s = 0.25;
  double max_delay_s = 8.0;
  double factor = 2.0;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("first_delay_s", first_delay_s, 0.01, 600.0, "");
    table.AddNumber("max_delay_s", max_delay_s, 0.01, 600.0, "");
    table.AddRule("max_delay_s", max_delay_s >= first_delay_s, "at least first_delay_s");
    table.AddNumber("factor", factor, 1.01, 10.0, "of one delay to the next");
  }
};

// How long to wait before the next attempt: grows from failure to failure up to a cap, and begins
// anew after a success.
class BackOff {
 public:
  explicit BackOff(const BackOffOptions& options)
      : options_(options), next_delay_s_(options.first_delay_s) {}

  // The wait after one more failure.
  double NextDelaySeconds();
  void Reset();

 private:
  const BackOffOptions options_;
  double next_delay_s_;
};

}  // namespace rovio_sfm
