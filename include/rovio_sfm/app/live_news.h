#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "rovio_sfm/app/mapping_engine.h"

namespace rovio_sfm {

// Tells people what became of sessions from one picture of the maps to the next: that one begins or
// is lost, and that two are joined, may be joined, or are parted again. Not thread-safe.
class LiveNews {
 public:
  // What a picture shows at the start is no news.
  explicit LiveNews(const MapPicture& start) { Take(start); }

  // A sentence each. Nothing where all maps were forgotten or replaced.
  std::vector<std::string> Since(const MapPicture& picture);

 private:
  std::vector<std::string> Take(const MapPicture& picture);
  std::string NewsOf(const SessionSnapshot& session);
  std::string NewsOf(const MergeReport& report);

  uint64_t epoch_ = 0;
  std::map<SessionId, SessionState> states_;  // of sessions that have frames
  std::map<uint32_t, MergeVerdict> verdicts_;
};

}  // namespace rovio_sfm
