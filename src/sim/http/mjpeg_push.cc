#include "rovio_sfm/sim/http/mjpeg_push.h"

#include "rovio_sfm/sim/http/http_response.h"
#include "rovio_sfm/sim/http/parameters.h"
#include "rovio_sfm/sim/http/status_string.h"

namespace rovio_sfm::sim {
namespace {

// How soon a waiting connection notices that its client is gone or that a quirk was switched off.
constexpr std::chrono::milliseconds kLookAround{100};

std::string StatusPart(const Caller& caller, ServerContext& context) {
  return std::string(kStatusPartHead) + FormatStatus(TakeSnapshot(context, caller.privilege)) +
         "\r\n";
}

std::string ImagePart(const Picture& picture) {
  std::string part(kImagePartHead);
  part.append(picture.jpeg->begin(), picture.jpeg->end());
  return part;
}

bool Send(TcpConnection& connection, const std::string& bytes, ServerContext& context) {
  return WaitWhileSilent(context) && connection.Write(bytes, context.options.request_timeout_ms);
}

bool ResetStrikes(ServerContext& context) {
  return context.quirks.With([](Quirks& quirks) { return quirks.Strikes(Quirk::kResetStream); });
}

}  // namespace

bool WaitWhileSilent(ServerContext& context) {
  const auto is_silent = [&] {
    const int64_t now = context.robot.now_ns();
    return context.quirks.With(
        [now](Quirks& quirks) { return quirks.IsActive(Quirk::kSilence, now); });
  };
  while (is_silent()) {
    if (context.stop.WaitFor(kLookAround)) return false;
  }
  return true;
}

std::optional<Picture> WaitForFreshPicture(const TcpConnection& connection, FrameFeed& frames) {
  const uint64_t begun = frames.LastBegun();
  while (!frames.IsClosed() && !connection.IsPeerGone()) {
    if (auto picture = frames.WaitForNewer(begun, kLookAround)) return picture;
  }
  return std::nullopt;
}

void PushStream(TcpConnection& connection, const HttpRequest& request, const Caller& caller,
                Picture first, ServerContext& context) {
  const bool with_status = Parameters::Parse(request.target_query).GetBool("Status");
  const std::chrono::milliseconds idle(context.options.stream_idle_ns / 1'000'000);
  HttpResponse response;
  response.content_type = kStreamContentType;
  const std::string head = SerializeHead(response, {}, context.robot.now_ns(), false);
  if (!Send(connection, head, context)) return;
  std::optional<Picture> next = std::move(first);
  uint64_t sent_number = 0;
  while (!context.frames.IsClosed()) {
    std::string bytes = next ? ImagePart(*next) : "";
    if (next) sent_number = next->number;
    if (with_status) bytes += StatusPart(caller, context);
    if (bytes.empty()) bytes = "\r\n";
    if (!Send(connection, bytes, context)) return;
    if (ResetStrikes(context)) return connection.ResetOnClose();
    next = context.frames.WaitForNewer(sent_number, idle);
  }
}

}  // namespace rovio_sfm::sim
