#pragma once

#include <string>

#include "rovio_sfm/sim/http/parameters.h"
#include "rovio_sfm/sim/http/request_router.h"

namespace rovio_sfm::sim {

// The simulator's own address, which no robot has: no login, and exempt from all quirks.
//   /sim?quirk=NAME&value=V   switches a quirk ("none": all off); replies "NAME = V"
//   /sim?quirks               lists all of them
//   /sim?truth                the true pose: time_ns, world_from_base and world_from_camera, each
//   as
//                             tx ty tz qx qy qz qw (metres, world z up)
// Malformed requests get 400 with the reason in the body.
RoutedReply AnswerSimRequest(const HttpRequest& request, ServerContext& context);

// Switches a quirk and what hangs on it (require_login). Quirk reboot yields the time away.
std::optional<std::chrono::nanoseconds> ApplyQuirk(const std::string& name, double value,
                                                   ServerContext& context, std::string* error);

}  // namespace rovio_sfm::sim
