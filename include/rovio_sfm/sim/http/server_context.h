#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "rovio_sfm/sim/http/accounts.h"
#include "rovio_sfm/sim/http/frame_feed.h"
#include "rovio_sfm/sim/http/guarded.h"
#include "rovio_sfm/sim/http/nav_memory.h"
#include "rovio_sfm/sim/http/nav_report.h"
#include "rovio_sfm/sim/http/open_streams.h"
#include "rovio_sfm/sim/http/quirks.h"
#include "rovio_sfm/sim/http/robot_access.h"
#include "rovio_sfm/sim/http/robot_settings.h"
#include "rovio_sfm/sim/http/stop_signal.h"

namespace rovio_sfm::sim {

struct HttpFaceOptions {
  int64_t drive_hold_ns = 250'000'000;     // [1 ns, 1 h] a drive command acts. Real: >= ~200 ms
  int64_t reboot_ns = 30'000'000'000;      // [0, 1 h] away after Reboot.cgi. The UI allows 30 s
  int64_t stream_idle_ns = 1'000'000'000;  // [1 ns, 1 h] without a picture, then a CRLF is sent
  int request_timeout_ms = 60'000;         // [1 ms, 1 h] for the next bytes of a request or a reply
  int idle_timeout_ms = 3'600'000;         // [1 ms, 1 h] between two requests of a connection

  bool IsValid(std::string* error) const;
};

// All that the handlers of one robot's requests share; every member guards itself. Lock order: the
// robot's lock (RobotAccess) before any other; the rest are leaves.
struct ServerContext {
  ServerContext(const HttpFaceOptions& options, RobotBackend& robot, Clock now_ns);

  const HttpFaceOptions options;
  Guarded<Quirks> quirks;
  Guarded<Accounts> accounts;
  Guarded<RobotSettings> settings;
  Guarded<NavMemory> nav_memory;
  RobotAccess robot;
  FrameFeed frames;
  OpenStreams streams;
  StopSignal stop;
  // One request at a time, as the robot's request loop; only taken with quirk hang_blocks_all.
  std::mutex request_loop;
};

// The robot as a caller of this level sees it reported now.
RobotSnapshot TakeSnapshot(ServerContext& context, Privilege caller_privilege);

}  // namespace rovio_sfm::sim
