#pragma once

#include <cstdint>
#include <string>

namespace rovio_sfm {

struct BackOffOptions {
  double first_delay_s = 0.25;
  double max_delay_s = 8.0;
  double factor = 2.0;

  bool IsValid(std::string* error) const;
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
