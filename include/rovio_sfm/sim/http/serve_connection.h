#pragma once

#include <chrono>
#include <functional>

#include "rovio_sfm/sim/http/server_context.h"
#include "rovio_sfm/sim/http/tcp_socket.h"

namespace rovio_sfm::sim {

// Called when the robot reboots: drop everybody and be away for so long. Must return at once.
using GoAway = std::function<void(std::chrono::nanoseconds)>;

// Answers the requests of one connection until it ends. Nothing that a client sends may harm.
void ServeConnection(TcpConnection& connection, ServerContext& context, const GoAway& go_away);

}  // namespace rovio_sfm::sim
