#pragma once

#include <string>

namespace rovio_sfm {

// Ends the program with file, line and message; use through ROVIO_CHECK, for our own bugs only.
[[noreturn]] void FailCheck(const char* file, int line, const char* condition,
                            const std::string& message);

}  // namespace rovio_sfm

// For what can only be a bug of ours; never on the content of a message, a file or a reply.
#define ROVIO_CHECK(condition, ...)                                                     \
  do {                                                                                  \
    if (!(condition)) {                                                                 \
      ::rovio_sfm::FailCheck(__FILE__, __LINE__, #condition, std::string{__VA_ARGS__}); \
    }                                                                                   \
  } while (false)
