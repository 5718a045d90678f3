#include "rovio_sfm/util/keep_memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdint>
#include <vector>

namespace rovio_sfm {
namespace {

long PageFaults() {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_minflt;
}

void TouchFourMegabytes() {
  std::vector<uint8_t> bytes(4u << 20, 1);
  EXPECT_EQ(bytes.back(), 1);
}

TEST(KeepFreedMemory, ClearsNoPageTwice) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers have a heap of their own";
#endif
  KeepFreedMemory();
  TouchFourMegabytes();
  const long before = PageFaults();
  for (int i = 0; i < 10; ++i) TouchFourMegabytes();
  EXPECT_LT(PageFaults() - before, 200) << "of 10240 pages";
}

}  // namespace
}  // namespace rovio_sfm
