#include "rovio_sfm/util/check.h"

#include <cstdlib>
#include <iostream>

namespace rovio_sfm {

void FailCheck(const char* file, int line, const char* condition, const std::string& message) {
  std::cerr << file << ":" << line << ": check failed: " << condition
            << (message.empty() ? "" : ": ") << message << std::endl;
  std::abort();
}

}  // namespace rovio_sfm
