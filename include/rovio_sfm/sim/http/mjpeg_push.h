#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "rovio_sfm/sim/http/http_request.h"
#include "rovio_sfm/sim/http/server_context.h"
#include "rovio_sfm/sim/http/tcp_socket.h"

namespace rovio_sfm::sim {

// The endless stream's content type and what stands before each part's bytes; nothing follows them.
inline constexpr std::string_view kStreamContentType =
    "multipart/x-mixed-replace;boundary=WINBONDBOUDARY";
inline constexpr std::string_view kImagePartHead =
    "--WINBONDBOUDARY\r\nContent-Type: image/jpeg\r\n\r\n";
inline constexpr std::string_view kStatusPartHead =
    "--WINBONDBOUDARY\r\nContent-Type: text/plain\r\n\r\n";

// Blocks for a picture whose capture begins after this call, however long that takes; nothing when
// the client or the server gives up.
std::optional<Picture> WaitForFreshPicture(const TcpConnection& connection, FrameFeed& frames);

// Sends pictures until the client, DropData or the server ends it. `first` is the picture that the
// robot waits for before it answers at all.
void PushStream(TcpConnection& connection, const HttpRequest& request, const Caller& caller,
                Picture first, ServerContext& context);

// Blocks while quirk `silence` holds all bytes back; false when the server stops meanwhile.
bool WaitWhileSilent(ServerContext& context);

}  // namespace rovio_sfm::sim
