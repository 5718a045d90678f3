#include "rovio_sfm/sim/http/serve_connection.h"

#include <mutex>
#include <utility>

#include "rovio_sfm/sim/http/http_request.h"
#include "rovio_sfm/sim/http/http_response.h"
#include "rovio_sfm/sim/http/mjpeg_push.h"
#include "rovio_sfm/sim/http/request_router.h"
#include "rovio_sfm/sim/http/sim_endpoint.h"

namespace rovio_sfm::sim {
namespace {

// One connection: the requests one after the other, and whether it goes on.
class Dialogue {
 public:
  Dialogue(TcpConnection& connection, ServerContext& context, const GoAway& go_away)
      : connection_(connection), context_(context), go_away_(go_away) {}

  void Run() {
    RequestReader reader(connection_, context_.options.idle_timeout_ms,
                         context_.options.request_timeout_ms);
    goes_on_ = true;
    for (int left = kKeepAliveRequests; goes_on_ && left > 0; --left) {
      HttpRequest request;
      const RequestStatus status = reader.ReadNext(&request);
      if (status == RequestStatus::kClosed) return;
      keep_alive_ = {request.keep_alive && status == RequestStatus::kComplete && left > 1,
                     left - 1};
      Answer(status, request);
      goes_on_ = goes_on_ && keep_alive_.enabled;
    }
  }

 private:
  void Answer(RequestStatus status, const HttpRequest& request) {
    if (status == RequestStatus::kComplete && request.path == "/sim") {
      FinishReply(AnswerSimRequest(request, context_));
    } else if (!WaitWhileSilent(context_) || Strikes(Quirk::kResetEvery)) {
      connection_.ResetOnClose();
      goes_on_ = false;
    } else if (status == RequestStatus::kBad) {
      Send(ErrorPage(400));
    } else if (status == RequestStatus::kPostTooLarge) {
      HttpResponse response;
      response.no_cache = false;
      response.body = "Too many post data or not enmough memory.";  // the firmware's spelling
      Send(response);
    } else {
      AnswerAsRobot(request);
    }
  }

  void AnswerAsRobot(const HttpRequest& request) {
    const Caller caller = context_.accounts.With(
        [&](Accounts& accounts) { return accounts.Authenticate(request.authorization); });
    if (request.method == "GET" && IsStillPath(request.path)) {
      SendStill(caller);
    } else if (IsStreamPath(request.path)) {
      SendStream(request, caller);
    } else {
      RoutedReply routed;
      {
        const auto turn = TakeTurn();
        routed = AnswerRequest(request, caller, context_);
      }
      FinishReply(routed);
    }
  }

  void SendStill(const Caller& caller) {
    if (const auto refusal = RefuseBelow(Privilege::kUser, caller)) return Send(*refusal);
    const auto picture = WaitForPicture();
    if (!picture) {
      goes_on_ = false;
      return;
    }
    HttpResponse response;
    response.content_type = "image/jpeg";
    response.body.assign(picture->jpeg->begin(), picture->jpeg->end());
    if (!Strikes(Quirk::kShortBody)) return Send(response);
    const std::string bytes = Serialize(response);
    goes_on_ = false;
    connection_.Write(bytes.substr(0, bytes.size() - response.body.size() / 2),
                      context_.options.request_timeout_ms);
  }

  void SendStream(const HttpRequest& request, const Caller& caller) {
    if (const auto refusal = RefuseBelow(Privilege::kUser, caller)) return Send(*refusal);
    goes_on_ = false;
    const OpenStreams::Entry entry(context_.streams, request.path, request.target_query,
                                   connection_);
    auto first = WaitForPicture();
    if (first) PushStream(connection_, request, caller, std::move(*first), context_);
  }

  std::optional<Picture> WaitForPicture() {
    const auto turn = TakeTurn();
    return WaitForFreshPicture(connection_, context_.frames);
  }

  // Holds the robot's single request loop while it lives, if the quirk wants that.
  std::unique_lock<std::mutex> TakeTurn() {
    std::unique_lock<std::mutex> turn(context_.request_loop, std::defer_lock);
    const bool one_at_a_time = context_.quirks.With(
        [](Quirks& quirks) { return quirks.Value(Quirk::kHangBlocksAll) > 0.0; });
    if (one_at_a_time) turn.lock();
    return turn;
  }

  bool Strikes(Quirk quirk) {
    return context_.quirks.With([quirk](Quirks& quirks) { return quirks.Strikes(quirk); });
  }

  void FinishReply(const RoutedReply& routed) {
    if (routed.away) keep_alive_.enabled = false;
    Send(routed.response);
    if (routed.away) go_away_(*routed.away);
  }

  std::string Serialize(const HttpResponse& response) const {
    return SerializeHead(response, keep_alive_, context_.robot.now_ns(), true) + response.body;
  }

  void Send(const HttpResponse& response) {
    goes_on_ = connection_.Write(Serialize(response), context_.options.request_timeout_ms);
  }

  TcpConnection& connection_;
  ServerContext& context_;
  const GoAway& go_away_;
  KeepAlive keep_alive_;
  bool goes_on_ = true;
};

}  // namespace

void ServeConnection(TcpConnection& connection, ServerContext& context, const GoAway& go_away) {
  Dialogue(connection, context, go_away).Run();
}

}  // namespace rovio_sfm::sim
