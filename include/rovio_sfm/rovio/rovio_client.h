#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rovio_sfm/rovio/drive_command.h"
#include "rovio_sfm/rovio/http_transport.h"
#include "rovio_sfm/rovio/rovio_protocol.h"

namespace rovio_sfm {

// Why the robot did not do it; kNone when it says that it did.
enum class RobotFault {
  kNone,
  kLink,      // no answer, or a broken one
  kDenied,    // 401: login missing, wrong or too low
  kStatus,    // another HTTP status than 200
  kRefused,   // a nav code other than success
  kMalformed  // 200 with a body that is not the answer
};

struct RobotOutcome {
  RobotFault fault = RobotFault::kNone;
  std::string message;  // for people, when there is a fault

  bool IsOk() const { return fault == RobotFault::kNone; }
};

template <typename T>
struct RobotReply {
  RobotOutcome outcome;
  std::optional<T> value;  // there exactly when the outcome is ok
};

// A still image as it came. The age is from its first byte to the end of the call.
struct StillImage {
  std::string jpeg;
  double age_s = 0.0;
};

// The robot's functions over one transport. A status of 200 is not taken for a success: the reply
// is read. Borrows the transport, which must outlive it; use from one thread at a time.
class RovioClient {
 public:
  explicit RovioClient(HttpTransport* transport) : transport_(transport) {}

  RobotOutcome Drive(const DriveCommand& command);  // kStop: action 33, then drive=0
  RobotOutcome MoveHead(HeadPosition position);
  RobotOutcome SetHeadlight(bool on);
  RobotOutcome SetInfrared(bool on);
  RobotOutcome Dock();         // returns at once; watch RobotReport::state
  RobotOutcome EndAutonomy();  // action 17

  RobotReply<RobotReport> GetReport();
  RobotReply<McuReport> GetMcuReport();  // clears the ticks
  RobotReply<StillImage> GetStill(size_t max_bytes);

  // Sends the wanted settings that differ from the present ones or are not known. The robot answers
  // before it has done so and hides refusals: read the report back, later.
  RobotOutcome RequestSettings(const SomeSettings& wanted, const SomeSettings& present);

 private:
  RobotOutcome SendNav(const std::string& target);
  RobotOutcome Fetch(const std::string& target, size_t max_bytes, HttpResponse* response);

  HttpTransport* const transport_;
  uint32_t num_stills_ = 0;
};

}  // namespace rovio_sfm
