#include "rovio_sfm/rovio/http_transport.h"

namespace rovio_sfm {

const char* NameOf(HttpFault fault) {
  switch (fault) {
    case HttpFault::kNone:
      return "none";
    case HttpFault::kConnect:
      return "no connection";
    case HttpFault::kTimeout:
      return "time-out";
    case HttpFault::kTooSlow:
      return "too slow";
    case HttpFault::kTooLarge:
      return "too large";
    case HttpFault::kMalformed:
      return "malformed answer";
    case HttpFault::kInterrupted:
      return "connection interrupted";
    case HttpFault::kCancelled:
      return "cancelled";
  }
  return "unknown";
}

}  // namespace rovio_sfm
