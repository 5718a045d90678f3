#include "rovio_sfm/ros/web_server.h"

#include <httplib.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <set>
#include <stdexcept>
#include <utility>

#include "rovio_sfm/util/mutex.h"
#include "rovio_sfm/util/worker.h"

namespace rovio_sfm {
namespace {

using Clock = std::chrono::steady_clock;

constexpr char kPolicy[] =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
    "img-src 'self' blob: data:; connect-src 'self'; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'";

Clock::time_point AfterSeconds(double seconds) {
  return Clock::now() +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

// A connection with an end in time and in bytes: cpp-httplib's own has neither.
class BoundedStream : public httplib::Stream {
 public:
  BoundedStream(socket_t socket, const WebLimits& limits)
      : socket_(socket),
        answer_s_(limits.answer_s),
        bytes_left_(limits.max_request_bytes),
        end_(AfterSeconds(limits.request_s)) {}

  bool is_readable() const override { return bytes_left_ > 0 && Wait(POLLIN); }
  bool is_writable() const override { return Wait(POLLOUT); }

  ssize_t read(char* bytes, size_t size) override {
    if (!is_readable()) return -1;
    const ssize_t count = ::recv(socket_, bytes, std::min(size, bytes_left_), 0);
    if (count > 0) bytes_left_ -= static_cast<size_t>(count);
    return count;
  }

  ssize_t write(const char* bytes, size_t size) override {
    if (!std::exchange(is_answering_, true)) end_ = AfterSeconds(answer_s_);
    return is_writable() ? ::send(socket_, bytes, size, MSG_NOSIGNAL | MSG_DONTWAIT) : -1;
  }

  void get_remote_ip_and_port(std::string& /*ip*/, int& /*port*/) const override {}
  void get_local_ip_and_port(std::string& /*ip*/, int& /*port*/) const override {}
  socket_t socket() const override { return socket_; }

 private:
  bool Wait(short event) const {
    pollfd entry{socket_, event, 0};
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end_ - Clock::now());
    const int left_ms = static_cast<int>(std::max<int64_t>(left.count(), 0));
    return ::poll(&entry, 1, left_ms) > 0 && (entry.revents & (event | POLLHUP)) != 0;
  }

  socket_t socket_;
  double answer_s_;
  size_t bytes_left_;
  Clock::time_point end_;
  bool is_answering_ = false;
};

// Threads, and a bound for those who wait for one: then the listening thread itself waits.
class BoundedThreads : public httplib::ThreadPool {
 public:
  explicit BoundedThreads(const WebLimits& limits)
      : ThreadPool(static_cast<size_t>(limits.num_threads)),
        max_tasks_(limits.num_threads + limits.max_waiting) {}

  void enqueue(std::function<void()> task) override {
    {
      MutexLock lock(mutex_);
      while (num_tasks_ >= max_tasks_) has_room_.wait(mutex_);
      ++num_tasks_;
    }
    ThreadPool::enqueue([this, task = std::move(task)] {
      task();
      const MutexLock lock(mutex_);
      --num_tasks_;
      has_room_.notify_one();
    });
  }

 private:
  const int max_tasks_;
  Mutex mutex_;
  std::condition_variable_any has_room_;
  int num_tasks_ GUARDED_BY(mutex_) = 0;
};

// Empty where it came more than once.
std::string HeaderOf(const httplib::Request& request, const char* name) {
  return request.get_header_value_count(name) == 1 ? request.get_header_value(name) : "";
}

std::optional<std::string> OptionalHeader(const httplib::Request& request, const char* name) {
  if (!request.has_header(name)) return std::nullopt;
  return HeaderOf(request, name);
}

// Of a request that tells no length, httplib would wait for bytes until the client hangs up.
bool HasBody(const httplib::Request& request) {
  return request.has_header("Content-Length") || request.has_header("Transfer-Encoding");
}

WebRequest FromHttp(const httplib::Request& http) {
  WebRequest request;
  request.method = http.method;
  request.path = http.path;
  request.since = http.get_param_value("since");
  request.host = HeaderOf(http, "Host");
  request.origin = OptionalHeader(http, "Origin");
  request.fetch_site = OptionalHeader(http, "Sec-Fetch-Site");
  request.token = HeaderOf(http, "X-Rovio-Token");
  request.content_type = HeaderOf(http, "Content-Type");
  request.body = http.body;
  return request;
}

void ToHttp(const WebAnswer& answer, httplib::Response* http) {
  http->status = answer.status;
  if (!answer.revision.empty()) http->set_header("X-Revision", answer.revision);
  if (answer.status == 405) http->set_header("Allow", "GET, POST");
  if (answer.body == nullptr) return;
  http->set_content_provider(
      answer.body->size(), answer.content_type.c_str(),
      [body = answer.body](size_t offset, size_t length, httplib::DataSink& sink) {
        return sink.write(body->data() + offset, length);
      });
}

// What is refused before anybody handles it.
std::string SentenceOf(int status, const WebLimits& limits) {
  switch (status) {
    case 400:
      return "not a request that HTTP/1.1 knows, or a header of more than 8 KiB\n";
    case 413:
      return "the body is too large: at most " + std::to_string(limits.max_body_bytes) +
             " bytes are taken\n";
    case 414:
      return "the address is too long: at most 8 KiB are taken\n";
    case 416:
      return "header Range: expected bytes=FIRST-LAST\n";
    default:
      return "the request was refused\n";
  }
}

void ExplainRefusal(const WebLimits& limits, httplib::Response* response) {
  if (response->content_length_ > 0 || !response->body.empty()) return;
  response->set_content(SentenceOf(response->status, limits), "text/plain; charset=utf-8");
}

}  // namespace

class WebServer::Listener : private httplib::Server {
 public:
  Listener(const std::string& address, int port, WebServer::Handler handler,
           const WebLimits& limits)
      : limits_(limits), handler_(std::move(handler)) {
    Configure();
    port_ = port == 0 ? bind_to_any_port(address) : (bind_to_port(address, port) ? port : -1);
    if (port_ < 0) {
      throw std::runtime_error("cannot listen on " + address + ":" + std::to_string(port) + ": " +
                               std::strerror(errno) + "; ~address and ~port choose another");
    }
    thread_.Push(0);
  }
  ~Listener() override { Stop(); }

  int port() const { return port_; }

  // What waits for a client ends with its connection; Server::stop() would wait for it, and do
  // nothing where listening has not begun.
  void Stop() {
    if (is_stopped_.exchange(true)) return;
    ::shutdown(svr_sock_, SHUT_RDWR);
    DropAll();
    thread_.Finish();
  }

 private:
  void Configure() {
    new_task_queue = [this] { return new BoundedThreads(limits_); };  // httplib deletes it
    set_payload_max_length(limits_.max_body_bytes);
    set_socket_options([](socket_t socket) {  // no SO_REUSEPORT: two servers would share a port
      const int yes = 1;
      ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
    });
    set_default_headers({{"Cache-Control", "no-store"},
                         {"Content-Security-Policy", kPolicy},
                         {"Cross-Origin-Resource-Policy", "same-origin"},
                         {"Referrer-Policy", "no-referrer"},
                         {"X-Content-Type-Options", "nosniff"},
                         {"X-Frame-Options", "DENY"}});
    const auto answer = [this](const httplib::Request& request, httplib::Response& response) {
      ToHttp(handler_(FromHttp(request)), &response);
    };
    set_error_handler([this](const httplib::Request& /*request*/, httplib::Response& response) {
      ExplainRefusal(limits_, &response);
    });
    Post(".*", answer);  // the body is read before
    set_pre_routing_handler([answer](const httplib::Request& request, httplib::Response& response) {
      if (request.method == "POST" && HasBody(request)) return HandlerResponse::Unhandled;
      answer(request, response);
      return HandlerResponse::Handled;
    });
  }

  bool process_and_close_socket(socket_t socket) override {
    const bool is_taken = Enter(socket);
    bool is_closed = false;
    BoundedStream stream(socket, limits_);
    // httplib would send what lies behind the answer in memory to who asks for more than it has.
    const auto ask_for_all = [](httplib::Request& request) { request.ranges.clear(); };
    const bool is_answered = is_taken && process_request(stream, true, is_closed, ask_for_all);
    Leave(socket);
    ::shutdown(socket, SHUT_RDWR);
    ::close(socket);
    return is_answered;
  }

  bool Enter(socket_t socket) EXCLUDES(mutex_) {
    const MutexLock lock(mutex_);
    clients_.insert(socket);
    return !is_stopped_;
  }

  void Leave(socket_t socket) EXCLUDES(mutex_) {
    const MutexLock lock(mutex_);
    clients_.erase(socket);
  }

  void DropAll() EXCLUDES(mutex_) {
    const MutexLock lock(mutex_);
    for (const socket_t client : clients_) ::shutdown(client, SHUT_RDWR);
  }

  const WebLimits limits_;
  const WebServer::Handler handler_;
  int port_ = -1;
  std::atomic<bool> is_stopped_{false};
  Mutex mutex_;
  std::set<socket_t> clients_ GUARDED_BY(mutex_);
  Worker<int> thread_{1, WhenFull::kBlock, [this](int) { listen_after_bind(); }};  // listens
};

WebServer::WebServer(const std::string& address, int port, Handler handler, const WebLimits& limits)
    : listener_(std::make_unique<Listener>(address, port, std::move(handler), limits)) {}

WebServer::~WebServer() = default;

int WebServer::port() const { return listener_->port(); }

void WebServer::Stop() { listener_->Stop(); }

}  // namespace rovio_sfm
