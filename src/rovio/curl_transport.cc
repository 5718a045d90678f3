#include "rovio_sfm/rovio/curl_transport.h"

#include <curl/curl.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <optional>

#include "rovio_sfm/rovio/header_value.h"
#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

using Clock = std::chrono::steady_clock;

void InitializeCurlOnce() {
  static const CURLcode code = curl_global_init(CURL_GLOBAL_DEFAULT);
  ROVIO_CHECK(code == CURLE_OK, "libcurl does not start");
}

double SecondsBetween(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

long Milliseconds(double seconds) { return std::lround(seconds * 1000.0); }

HttpFault FaultOf(CURLcode code) {
  switch (code) {
    case CURLE_OK:
      return HttpFault::kNone;
    case CURLE_COULDNT_CONNECT:
    case CURLE_COULDNT_RESOLVE_HOST:
      return HttpFault::kConnect;
    case CURLE_OPERATION_TIMEDOUT:
      return HttpFault::kTimeout;
    case CURLE_FILESIZE_EXCEEDED:
      return HttpFault::kTooLarge;
    case CURLE_WEIRD_SERVER_REPLY:
    case CURLE_UNSUPPORTED_PROTOCOL:
    case CURLE_BAD_CONTENT_ENCODING:
      return HttpFault::kMalformed;
    default:
      return HttpFault::kInterrupted;
  }
}

template <typename T>
void Set(CURL* easy, CURLoption option, T value) {
  ROVIO_CHECK(curl_easy_setopt(easy, option, value) == CURLE_OK, "libcurl lacks an option");
}

}  // namespace

// libcurl's objects, with their one deleter.
struct CurlTransport::Handles {
  Handles() : multi(curl_multi_init()), easy(curl_easy_init()) {
    ROVIO_CHECK(multi != nullptr && easy != nullptr, "libcurl gives no handle");
  }
  ~Handles() {
    curl_easy_cleanup(easy);
    curl_multi_cleanup(multi);
    curl_slist_free_all(headers);
  }
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;

  CURLM* const multi;
  CURL* const easy;
  curl_slist* headers = nullptr;
};

// One request and what has come of its answer so far.
struct CurlTransport::Exchange {
  explicit Exchange(const CurlTransportOptions& the_options) : options(the_options) {}

  const CurlTransportOptions& options;
  const StreamReceiver* receiver = nullptr;  // null: the body is collected
  size_t max_body_bytes = 0;
  HttpResponse response;
  Clock::time_point start = Clock::now();
  std::optional<Clock::time_point> first_byte;
  std::optional<Clock::time_point> last_byte;
  Clock::time_point window_start = start;
  size_t window_bytes = 0;
  size_t header_bytes = 0;
  size_t header_lines = 0;
  std::optional<size_t> content_length;
  bool has_told_header = false;

  bool FailExchange(HttpFault fault, const std::string& message) {
    if (response.fault == HttpFault::kNone) {
      response.fault = fault;
      response.message = message;
    }
    return false;
  }

  void NoteBytes(size_t count) {
    last_byte = Clock::now();
    if (!first_byte) first_byte = last_byte;
    window_bytes += count;
  }

  bool TakeHeaderLine(std::string_view line) {
    NoteBytes(line.size());
    header_bytes += line.size();
    if (header_bytes > options.max_header_bytes || ++header_lines > options.max_header_lines) {
      return FailExchange(HttpFault::kTooLarge, "header above its cap");
    }
    if (const auto type = HeaderValue(line, "Content-Type")) response.content_type = *type;
    const auto value = HeaderValue(line, "Content-Length");
    return !value || TakeContentLength(*value);
  }

  bool TakeContentLength(std::string_view value) {
    const std::optional<size_t> length = ParseContentLength(value);
    if (!length || content_length) {
      return FailExchange(HttpFault::kMalformed,
                          "negative, overflowing or duplicate Content-Length");
    }
    content_length = length;
    if (receiver == nullptr && *length > max_body_bytes) {
      return FailExchange(HttpFault::kTooLarge, "announced body above its cap");
    }
    return true;
  }

  bool TakeBody(std::string_view bytes, int status) {
    NoteBytes(bytes.size());
    response.status = status;
    if (receiver != nullptr) return HandOn(bytes);
    if (response.body.size() + bytes.size() > max_body_bytes) {
      return FailExchange(HttpFault::kTooLarge, "body above its cap");
    }
    response.body.append(bytes);
    return true;
  }

  bool HandOn(std::string_view bytes) {
    const bool is_first = !has_told_header;
    has_told_header = true;
    if (is_first && !receiver->on_header(response.status, response.content_type)) {
      return FailExchange(HttpFault::kCancelled, "answer not wanted");
    }
    return receiver->on_bytes(bytes) ||
           FailExchange(HttpFault::kCancelled, "receiver wants no more");
  }

  // Checks the waits that libcurl does not know; false when one is over.
  bool IsInTime(Clock::time_point now) {
    if (!last_byte) {
      return SecondsBetween(start, now) <=
                 options.connect_timeout_s + options.first_byte_timeout_s ||
             FailExchange(HttpFault::kTimeout, "no first byte in time");
    }
    if (SecondsBetween(*last_byte, now) > options.between_bytes_timeout_s) {
      return FailExchange(HttpFault::kTimeout, "a pause between bytes is too long");
    }
    const double window_s = SecondsBetween(window_start, now);
    if (receiver == nullptr || window_s < options.min_speed_window_s) return true;
    const bool is_fast = static_cast<double>(window_bytes) >= options.min_bytes_per_s * window_s;
    window_start = now;
    window_bytes = 0;
    return is_fast || FailExchange(HttpFault::kTooSlow, "fewer bytes a second than asked for");
  }

  static size_t OnHeader(char* data, size_t size, size_t count, void* self) {
    const size_t length = size * count;
    return static_cast<Exchange*>(self)->TakeHeaderLine({data, length}) ? length : 0;
  }

  static size_t OnBody(char* data, size_t size, size_t count, void* self) {
    Exchange* const exchange = static_cast<Exchange*>(self);
    long status = 0;
    curl_easy_getinfo(exchange->easy, CURLINFO_RESPONSE_CODE, &status);
    const size_t length = size * count;
    return exchange->TakeBody({data, length}, static_cast<int>(status)) ? length : length + 1;
  }

  CURL* easy = nullptr;
};

bool IsHostName(const std::string& host) {
  if (host.empty() || host.size() > 253 || host.front() == '-' || host.front() == '.') return false;
  return std::all_of(host.begin(), host.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '.' || c == '_';
  });
}

CurlTransport::CurlTransport(const CurlTransportOptions& options, const Credentials& credentials)
    : options_(options), handles_((InitializeCurlOnce(), std::make_unique<Handles>())) {
  std::string error;
  ROVIO_CHECK(IsValid(options, &error), error);
  CURL* const easy = handles_->easy;
  handles_->headers = curl_slist_append(nullptr, "Connection: Keep-Alive");
  Set(easy, CURLOPT_HTTPHEADER, handles_->headers);
  Set(easy, CURLOPT_PROTOCOLS_STR, "http");
  Set(easy, CURLOPT_FOLLOWLOCATION, 0L);
  Set(easy, CURLOPT_PROXY, "");
  Set(easy, CURLOPT_NOSIGNAL, 1L);
  Set(easy, CURLOPT_TCP_NODELAY, 1L);
  Set(easy, CURLOPT_CONNECTTIMEOUT_MS, Milliseconds(options.connect_timeout_s));
  Set(easy, CURLOPT_HEADERFUNCTION, &Exchange::OnHeader);
  Set(easy, CURLOPT_WRITEFUNCTION, &Exchange::OnBody);
  if (credentials.user.empty()) return;
  Set(easy, CURLOPT_HTTPAUTH, CURLAUTH_BASIC);
  Set(easy, CURLOPT_USERNAME, credentials.user.c_str());
  Set(easy, CURLOPT_PASSWORD, credentials.password.c_str());
}

CurlTransport::~CurlTransport() = default;

void CurlTransport::Cancel() {
  is_cancelled_ = true;
  curl_multi_wakeup(handles_->multi);
}

HttpResponse CurlTransport::Get(const std::string& target, size_t max_body_bytes) {
  Exchange exchange(options_);
  exchange.max_body_bytes = max_body_bytes;
  return Perform(target, &exchange);
}

HttpResponse CurlTransport::Stream(const std::string& target, const StreamReceiver& receiver) {
  Exchange exchange(options_);
  exchange.receiver = &receiver;
  return Perform(target, &exchange);
}

void CurlTransport::Prepare(const std::string& target, Exchange* exchange) {
  CURL* const easy = handles_->easy;
  exchange->easy = easy;
  const std::string url = "http://" + options_.host + ":" + std::to_string(options_.port) + target;
  Set(easy, CURLOPT_URL, url.c_str());
  Set(easy, CURLOPT_HEADERDATA, exchange);
  Set(easy, CURLOPT_WRITEDATA, exchange);
  Set(easy, CURLOPT_TIMEOUT_MS,
      exchange->receiver == nullptr ? Milliseconds(options_.total_timeout_s) : 0L);
}

HttpResponse CurlTransport::Perform(const std::string& target, Exchange* exchange) {
  ROVIO_CHECK(!target.empty() && target.front() == '/', "a target begins with a slash");
  Prepare(target, exchange);
  curl_multi_add_handle(handles_->multi, handles_->easy);
  DriveUntilDone(exchange);
  curl_multi_remove_handle(handles_->multi, handles_->easy);
  long status = 0;
  curl_easy_getinfo(handles_->easy, CURLINFO_RESPONSE_CODE, &status);
  exchange->response.status = static_cast<int>(status);
  if (exchange->first_byte) {
    exchange->response.body_duration_s = SecondsBetween(*exchange->first_byte, Clock::now());
  }
  return std::move(exchange->response);
}

// Polls until libcurl is done, a wait is over, or somebody cancels.
void CurlTransport::DriveUntilDone(Exchange* exchange) {
  constexpr int kPollMs = 100;  // how exactly waits are kept; bytes and Cancel wake it at once
  int num_running = 1;
  while (true) {
    curl_multi_perform(handles_->multi, &num_running);
    if (num_running == 0) break;
    if (is_cancelled_) {
      exchange->FailExchange(HttpFault::kCancelled, "cancelled");
      return;
    }
    if (!exchange->IsInTime(Clock::now())) return;
    curl_multi_poll(handles_->multi, nullptr, 0, kPollMs, nullptr);
  }
  int num_left = 0;
  const CURLMsg* const message = curl_multi_info_read(handles_->multi, &num_left);
  if (message == nullptr) return;
  const CURLcode code = message->data.result;
  if (code != CURLE_OK) exchange->FailExchange(FaultOf(code), curl_easy_strerror(code));
}

}  // namespace rovio_sfm
