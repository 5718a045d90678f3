#include "rovio_sfm/util/peak_memory.h"

#include <gtest/gtest.h>

#include <vector>

namespace rovio_sfm {
namespace {

TEST(PeakMemoryMb, GrowsByWhatIsTouched) {
  const double before_mb = PeakMemoryMb();
  EXPECT_GT(before_mb, 1.0);
  const std::vector<char> touched(static_cast<size_t>(2.0 * before_mb * 1024.0 * 1024.0), 1);
  EXPECT_GT(PeakMemoryMb(), 1.5 * before_mb) << touched.back();
}

}  // namespace
}  // namespace rovio_sfm
