#include "rovio_sfm/sim/http/http_request.h"

#include <strings.h>

#include <algorithm>
#include <vector>

#include "rovio_sfm/sim/http/parameters.h"

namespace rovio_sfm::sim {
namespace {

// Bytes of a body past the limit that are still read, so that the client sees the answer.
constexpr size_t kMaxDrainedBytes = 1 << 20;

std::string_view Trim(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

bool EqualIgnoringCase(std::string_view a, std::string_view b) {
  return a.size() == b.size() && strncasecmp(a.data(), b.data(), a.size()) == 0;
}

// Takes the next line, without its end, off the text.
std::string_view TakeLine(std::string_view* text) {
  std::string_view line = text->substr(0, text->find('\n'));
  text->remove_prefix(std::min(text->size(), line.size() + 1));
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

std::string_view TakeWord(std::string_view* line) {
  *line = Trim(*line);
  const std::string_view word = line->substr(0, line->find(' '));
  line->remove_prefix(word.size());
  return word;
}

bool ParseRequestLine(std::string_view line, HttpRequest* request) {
  request->method = TakeWord(&line);
  const std::string_view target = TakeWord(&line);
  const std::string_view version = Trim(line);
  if (target.empty() || target.front() != '/') return false;
  if (!version.empty() && version.substr(0, 5) != "HTTP/") return false;
  const size_t question = std::min(target.find('?'), target.size());
  std::string path = DecodeUrl(target.substr(0, question), false);
  path.erase(0, path.find_first_not_of('/'));
  request->path = "/" + path;
  request->target_query = target.substr(std::min(target.size(), question + 1));
  request->query = request->target_query;
  return path.find('\0') == std::string::npos;
}

bool ParseContentLength(std::string_view value, HttpRequest* request, bool* seen) {
  const auto length = ParseLong(value);
  if (!length || *length < 0 || *seen) return false;
  *seen = true;
  request->content_length = static_cast<size_t>(*length);
  return true;
}

}  // namespace

std::optional<HttpRequest> ParseRequestHead(std::string_view head) {
  HttpRequest request;
  if (!ParseRequestLine(TakeLine(&head), &request)) return std::nullopt;
  bool length_seen = false;
  while (!head.empty()) {
    const std::string_view line = TakeLine(&head);
    const size_t colon = line.find(':');
    if (colon == std::string_view::npos) continue;
    const std::string_view name = line.substr(0, colon);
    const std::string_view value = Trim(line.substr(colon + 1));
    if (EqualIgnoringCase(name, "Connection")) {
      request.keep_alive = EqualIgnoringCase(value, "Keep-Alive");
    } else if (EqualIgnoringCase(name, "Authorization")) {
      request.authorization = value;
    } else if (EqualIgnoringCase(name, "Content-Length")) {
      if (!ParseContentLength(value, &request, &length_seen)) return std::nullopt;
    }
  }
  return request;
}

RequestReader::RequestReader(TcpConnection& connection, int idle_timeout_ms, int timeout_ms)
    : connection_(connection), idle_timeout_ms_(idle_timeout_ms), timeout_ms_(timeout_ms) {}

RequestStatus RequestReader::ReadNext(HttpRequest* request) {
  std::string head;
  const RequestStatus status = ReadHead(&head);
  if (status != RequestStatus::kComplete) return status;
  auto parsed = ParseRequestHead(head);
  if (!parsed) return RequestStatus::kBad;
  *request = std::move(*parsed);
  return ReadBody(request);
}

RequestStatus RequestReader::ReadHead(std::string* head) {
  size_t line_begin = 0;
  for (size_t i = 0;; ++i) {
    while (i >= pending_.size()) {
      if (!ReadMore(i == 0 ? idle_timeout_ms_ : timeout_ms_)) return RequestStatus::kClosed;
    }
    if (i >= kMaxHeadBytes || i - line_begin >= kMaxHeaderLineBytes) return RequestStatus::kBad;
    if (pending_[i] != '\n') continue;
    const bool line_is_empty =
        i == line_begin || (i == line_begin + 1 && pending_[line_begin] == '\r');
    const bool leading = line_is_empty && line_begin == 0;
    if (line_is_empty && !leading) {
      *head = pending_.substr(0, line_begin);
      pending_.erase(0, i + 1);
      return RequestStatus::kComplete;
    }
    if (leading) {  // blank lines before a request count for nothing
      pending_.erase(0, i + 1);
      i = static_cast<size_t>(-1);
    }
    line_begin = i + 1;
  }
}

RequestStatus RequestReader::ReadBody(HttpRequest* request) {
  const size_t wanted = request->content_length;
  if (wanted >= kMaxPostBytes) {
    size_t drained = 0;
    while (drained < std::min(wanted, kMaxDrainedBytes)) {
      if (pending_.empty() && !ReadMore(timeout_ms_)) return RequestStatus::kClosed;
      const size_t taken = std::min(pending_.size(), wanted - drained);
      pending_.erase(0, taken);
      drained += taken;
    }
    return RequestStatus::kPostTooLarge;
  }
  while (pending_.size() < wanted) {
    if (!ReadMore(timeout_ms_)) return RequestStatus::kClosed;
  }
  if (request->method == "POST") {
    std::string body = pending_.substr(0, wanted);
    while (!body.empty() && (body.back() == '\n' || body.back() == '\r')) body.pop_back();
    request->query = std::move(body);
  }
  pending_.erase(0, wanted);
  return RequestStatus::kComplete;
}

bool RequestReader::ReadMore(int timeout_ms) {
  constexpr size_t kChunkBytes = 2048;
  return connection_.Read(kChunkBytes, timeout_ms, &pending_) == ReadStatus::kData;
}

}  // namespace rovio_sfm::sim
