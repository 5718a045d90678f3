#include "rovio_sfm/app/progress_bar.h"

#include <algorithm>
#include <cstdint>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace rovio_sfm {
namespace {

constexpr size_t kWidth = 30;
constexpr double kPeriodS = 0.1;

}  // namespace

std::string ProgressText(size_t done, size_t total, double elapsed_s) {
  done = std::min(done, total);
  const size_t filled = total == 0 ? kWidth : kWidth * done / total;
  std::ostringstream text;
  text << '[' << std::string(filled, '#') << std::string(kWidth - filled, '.') << "] "
       << std::setw(3) << (total == 0 ? 100 : 100 * done / total) << " %  " << done << '/' << total;
  if (done == 0) return text.str();
  const double left_s = elapsed_s * static_cast<double>(total - done) / static_cast<double>(done);
  const auto seconds = static_cast<int64_t>(left_s + 0.5);
  text << "  " << seconds / 60 << ':' << std::setw(2) << std::setfill('0') << seconds % 60
       << " left";
  return text.str();
}

void ProgressBar::Show(size_t done, double elapsed_s) {
  if (last_s_ >= 0.0 && elapsed_s - last_s_ < kPeriodS) return;
  last_s_ = elapsed_s;
  *out_ << '\r' << ProgressText(done, total_, elapsed_s) << "  " << std::flush;
}

void ProgressBar::Finish(double elapsed_s) {
  *out_ << '\r' << ProgressText(total_, total_, elapsed_s) << "  \n" << std::flush;
}

}  // namespace rovio_sfm
