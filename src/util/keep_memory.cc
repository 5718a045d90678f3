#include "rovio_sfm/util/keep_memory.h"

#include <malloc.h>

namespace rovio_sfm {
namespace {

constexpr int kMaxMappedBytes = 32 << 20;  // greatest that glibc takes; larger blocks are unmapped
constexpr int kKeptBytes = 512 << 20;      // free at the end of the heap
constexpr int kGrowBytes = 32 << 20;       // address space taken at once, untouched

}  // namespace

void KeepFreedMemory() {
  mallopt(M_MMAP_THRESHOLD, kMaxMappedBytes);
  mallopt(M_TRIM_THRESHOLD, kKeptBytes);
  mallopt(M_TOP_PAD, kGrowBytes);
}

}  // namespace rovio_sfm
