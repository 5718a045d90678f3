#include "rovio_sfm/rovio/mjpeg_parser.h"

#include <algorithm>
#include <utility>

#include "rovio_sfm/rovio/header_value.h"
#include "rovio_sfm/util/jpeg_check.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMaxBoundaryBytes = 70;  // RFC 2046

bool StartsIgnoringCase(std::string_view text, std::string_view prefix) {
  return EqualsIgnoringCase(text.substr(0, prefix.size()), prefix);
}

bool EndsWholeJpeg(std::string_view body) {
  const size_t last = body.find_last_not_of("\r\n");
  if (last == std::string_view::npos || static_cast<unsigned char>(body[last]) != 0xD9)
    return false;
  const JpegInfo info = CheckJpegMarkers(body, SIZE_MAX);
  return info.fault == JpegFault::kNone && info.num_bytes == last + 1;
}

}  // namespace

const char* NameOf(MjpegFault fault) {
  switch (fault) {
    case MjpegFault::kNone:
      return "none";
    case MjpegFault::kHeaderTooLong:
      return "header of a part too long";
    case MjpegFault::kPartTooLong:
      return "part too long";
    case MjpegFault::kTooMuchJunk:
      return "no boundary in too many bytes";
    case MjpegFault::kBadContentLength:
      return "bad or duplicate length of a part";
  }
  return "unknown";
}

std::optional<std::string> BoundaryOf(std::string_view content_type) {
  if (!StartsIgnoringCase(Trim(content_type), "multipart/")) return std::nullopt;
  size_t at = content_type.find(';');
  while (at != std::string_view::npos) {
    const size_t next = content_type.find(';', at + 1);
    std::string_view item = Trim(content_type.substr(at + 1, next - at - 1));
    at = next;
    if (!StartsIgnoringCase(item, "boundary=")) continue;
    item = Trim(item.substr(9));
    if (item.size() >= 2 && item.front() == '"' && item.back() == '"') {
      item = item.substr(1, item.size() - 2);
    }
    while (!item.empty() && item.front() == '-') item.remove_prefix(1);
    if (item.empty() || item.size() > kMaxBoundaryBytes) return std::nullopt;
    return std::string(item);
  }
  return std::nullopt;
}

MjpegParser::MjpegParser(std::string_view boundary, const MjpegParserOptions& options,
                         OnPart on_part)
    : delimiter_("--" + std::string(boundary)), options_(options), on_part_(std::move(on_part)) {}

bool MjpegParser::Feed(std::string_view bytes, int64_t stamp_ns) {
  if (fault_ != MjpegFault::kNone) return false;
  buffer_.append(bytes);
  arrivals_.push_back({buffer_.size(), stamp_ns});
  while (Step()) {
  }
  return fault_ == MjpegFault::kNone;
}

// Each step consumes something and returns true, or needs more bytes (or failed): false.
bool MjpegParser::Step() {
  switch (state_) {
    case State::kJunk:
      return SkipJunk();
    case State::kHeader:
      return ReadHeaderLine();
    case State::kBody:
      return content_length_ ? ReadBodyOfKnownLength() : ReadBody();
  }
  return false;
}

bool MjpegParser::SkipJunk() {
  const size_t at = FindDelimiter();
  junk_bytes_ += at == std::string::npos ? searched_ : at;
  if (at != std::string::npos) {
    StartPart(at);
    return true;
  }
  Discard(searched_);
  if (junk_bytes_ > options_.max_junk_bytes) FailStream(MjpegFault::kTooMuchJunk);
  return false;
}

bool MjpegParser::ReadHeaderLine() {
  const size_t end = buffer_.find('\n');
  const size_t length = end == std::string::npos ? buffer_.size() : end + 1;
  if (header_bytes_ + length > options_.max_header_bytes)
    return FailStream(MjpegFault::kHeaderTooLong);
  if (end == std::string::npos) return false;
  header_bytes_ += length;
  const std::string line(Trim(std::string_view(buffer_).substr(0, end)));
  Discard(length);
  const bool is_first = header_lines_ == 0;
  if (++header_lines_ > options_.max_header_lines + 2)
    return FailStream(MjpegFault::kHeaderTooLong);
  if (is_first) {  // what stands behind the boundary: nothing, or it was another boundary
    if (!line.empty()) state_ = State::kJunk;
    return true;
  }
  if (!line.empty()) return AcceptHeaderLine(line);
  state_ = State::kBody;
  return true;
}

bool MjpegParser::AcceptHeaderLine(std::string_view line) {
  if (const auto type = HeaderValue(line, "Content-Type")) {
    is_image_ = StartsIgnoringCase(*type, "image/");
  }
  const auto value = HeaderValue(line, "Content-Length");
  if (!value) return true;
  const std::optional<size_t> length = ParseContentLength(*value);
  if (!length || content_length_) return FailStream(MjpegFault::kBadContentLength);
  if (*length > options_.max_part_bytes) return FailStream(MjpegFault::kPartTooLong);
  content_length_ = length;
  return true;
}

bool MjpegParser::ReadBodyOfKnownLength() {
  if (buffer_.size() < *content_length_) return false;
  EmitBody(*content_length_);
  state_ = State::kJunk;
  return true;
}

bool MjpegParser::ReadBody() {
  const size_t at = FindDelimiter();
  if (std::min(at, buffer_.size()) > options_.max_part_bytes + delimiter_.size()) {
    return FailStream(MjpegFault::kPartTooLong);
  }
  if (at != std::string::npos) {
    EmitBody(at);
    StartPart(0);
    return true;
  }
  if (!is_image_ || !EndsWholeJpeg(buffer_)) return false;
  EmitBody(buffer_.size());
  state_ = State::kJunk;
  return false;
}

void MjpegParser::EmitBody(size_t length) {
  std::string body = buffer_.substr(0, length);
  Discard(length);
  if (!content_length_) body.erase(body.find_last_not_of("\r\n") + 1);
  if (!is_image_) {
    ++num_skipped_parts_;
  } else if (!body.empty()) {
    on_part_({part_stamp_ns_, std::move(body)});
  }
}

void MjpegParser::StartPart(size_t delimiter_at) {
  while (arrivals_.size() > 1 && arrivals_.front().end <= delimiter_at) arrivals_.pop_front();
  part_stamp_ns_ = arrivals_.front().stamp_ns;
  Discard(delimiter_at + delimiter_.size());
  state_ = State::kHeader;
  junk_bytes_ = header_bytes_ = header_lines_ = 0;
  is_image_ = true;
  content_length_.reset();
}

void MjpegParser::Discard(size_t count) {
  buffer_.erase(0, count);
  searched_ -= std::min(searched_, count);
  while (!arrivals_.empty() && arrivals_.front().end <= count) arrivals_.pop_front();
  for (Arrival& arrival : arrivals_) arrival.end -= count;
}

// Looks only where nobody has looked yet, so that a slow stream costs no more than a fast one.
size_t MjpegParser::FindDelimiter() {
  const size_t at = buffer_.find(delimiter_, searched_);
  if (at == std::string::npos && buffer_.size() >= delimiter_.size()) {
    searched_ = buffer_.size() - delimiter_.size() + 1;
  }
  return at;
}

bool MjpegParser::FailStream(MjpegFault fault) {
  fault_ = fault;
  buffer_.clear();
  return false;
}

}  // namespace rovio_sfm
