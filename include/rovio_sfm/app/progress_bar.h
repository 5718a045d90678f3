#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

namespace rovio_sfm {

// "[#####.....]  50 %  12/24  0:07 left" after `elapsed_s` of work on `done` of `total` items.
std::string ProgressText(size_t done, size_t total, double elapsed_s);

// Draws the bar over itself on one line, at most ten times a second of the time it is told.
class ProgressBar {
 public:
  ProgressBar(size_t total, std::ostream* out) : total_(total), out_(out) {}

  void Show(size_t done, double elapsed_s);
  void Finish(double elapsed_s);  // draws the full bar and ends the line

 private:
  size_t total_;
  std::ostream* out_;
  double last_s_ = -1.0;
};

}  // namespace rovio_sfm
