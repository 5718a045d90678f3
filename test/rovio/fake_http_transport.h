#pragma once

#include <deque>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "rovio_sfm/rovio/http_transport.h"

namespace rovio_sfm {

// A robot made of prepared answers. Remembers every target it was asked for. An answer that is used
// up is repeated if it is the last of its target; unknown targets get 404.
class FakeHttpTransport : public HttpTransport {
 public:
  // What a Stream does: header, chunks of bytes, then the end with a fault or none.
  struct StreamScript {
    int status = 200;
    std::string content_type = "multipart/x-mixed-replace;boundary=WINBONDBOUDARY";
    std::vector<std::string> chunks;
    HttpFault fault = HttpFault::kInterrupted;
  };

  static HttpResponse Ok(std::string body) {
    HttpResponse response;
    response.status = 200;
    response.body = std::move(body);
    return response;
  }
  static HttpResponse Status(int status) {
    HttpResponse response;
    response.status = status;
    return response;
  }
  static HttpResponse Fault(HttpFault fault) {
    HttpResponse response;
    response.fault = fault;
    response.message = "as the test wants";
    return response;
  }

  void Answer(const std::string& target, HttpResponse response) {
    answers_[target].push_back(std::move(response));
  }
  void AnswerStill(HttpResponse response) { stills_.push_back(std::move(response)); }
  void AnswerStream(StreamScript script) { streams_.push_back(std::move(script)); }

  HttpResponse Get(const std::string& target, size_t max_body_bytes) override {
    targets.push_back(target);
    const bool is_still = target.rfind("/Jpeg/", 0) == 0;
    HttpResponse response = Take(is_still ? &stills_ : &answers_[target], Status(404));
    if (response.body.size() > max_body_bytes) return Fault(HttpFault::kTooLarge);
    return response;
  }

  HttpResponse Stream(const std::string& target, const StreamReceiver& receiver) override {
    targets.push_back(target);
    StreamScript none;
    none.fault = HttpFault::kConnect;
    none.status = 0;
    const StreamScript script = Take(&streams_, none);
    HttpResponse response = Status(script.status);
    response.content_type = script.content_type;
    response.fault = script.fault;
    if (script.status == 0) return response;
    if (!receiver.on_header(script.status, script.content_type)) return Cancelled(response);
    for (const std::string& chunk : script.chunks) {
      if (!receiver.on_bytes(chunk)) return Cancelled(response);
    }
    return response;
  }

  void Cancel() override {}

  std::vector<std::string> targets;

 private:
  template <typename T>
  static T Take(std::deque<T>* script, T otherwise) {
    if (script->empty()) return otherwise;
    T item = script->front();
    if (script->size() > 1) script->pop_front();
    return item;
  }

  static HttpResponse Cancelled(HttpResponse response) {
    response.fault = HttpFault::kCancelled;
    return response;
  }

  std::map<std::string, std::deque<HttpResponse>> answers_;
  std::deque<HttpResponse> stills_;
  std::deque<StreamScript> streams_;
};

}  // namespace rovio_sfm
