#include "rovio_sfm/surface/drop_chatter.h"

#include <cstdio>
#include <string_view>

#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm {
namespace {

constexpr std::string_view kChatter = "Vertex pair not in list";

Mutex mutex;
int num_living GUARDED_BY(mutex) = 0;
FILE* const true_stdout = stdout;

// What a line-buffered stream hands on begins with a line.
ssize_t WriteThrough(void*, const char* bytes, size_t size) {
  const std::string_view text(bytes, size);
  if (text.substr(0, kChatter.size()) == kChatter) return static_cast<ssize_t>(size);
  const size_t written = std::fwrite(bytes, 1, size, true_stdout);
  std::fflush(true_stdout);
  return static_cast<ssize_t>(written);
}

// Never closed: a thread may print into it still when it stands for the standard output no more.
FILE* Sieve() {
  static FILE* const sieve = [] {
    cookie_io_functions_t functions = {};
    functions.write = WriteThrough;
    FILE* const stream = ::fopencookie(nullptr, "w", functions);
    ROVIO_CHECK(stream != nullptr, "no memory for a stream");
    std::setvbuf(stream, nullptr, _IOLBF, BUFSIZ);
    return stream;
  }();
  return sieve;
}

}  // namespace

DropChatter::DropChatter() {
  MutexLock lock(mutex);
  if (num_living++ == 0) stdout = Sieve();
}

DropChatter::~DropChatter() {
  MutexLock lock(mutex);
  if (--num_living > 0) return;
  stdout = true_stdout;
  std::fflush(Sieve());
}

}  // namespace rovio_sfm
