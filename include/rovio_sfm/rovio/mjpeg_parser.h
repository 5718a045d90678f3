#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace rovio_sfm {

struct MjpegParserOptions {
  size_t max_header_bytes = 2048;        // of one part
  size_t max_header_lines = 16;          // of one part
  uint64_t max_part_bytes = 512 * 1024;  // a VGA JPEG of a Rovio stays below 64 KiB
  size_t max_junk_bytes = 1024 * 1024;   // between two boundaries, before the stream is given up
};

// One image of the stream. The stamp is that of the first byte of its boundary.
struct MjpegPart {
  int64_t stamp_ns = 0;
  std::string body;
};

// Why the parser gave up; it then refuses all further bytes.
enum class MjpegFault { kNone, kHeaderTooLong, kPartTooLong, kTooMuchJunk, kBadContentLength };

const char* NameOf(MjpegFault fault);

// The boundary of a multipart content type ("…;boundary=WINBONDBOUDARY", with or without quotes and
// leading dashes), without dashes; nothing when it is no multipart type or the boundary is odd.
std::optional<std::string> BoundaryOf(std::string_view content_type);

// Cuts a multipart stream into parts, however its bytes arrive. Takes what the robot sends: no part
// length, no line end before a boundary, bare line ends when idle, LF alone, junk between parts.
// A part without length ends at the next boundary, or at once when its bytes end a whole JPEG.
// Parts of another type than an image are skipped.
class MjpegParser {
 public:
  using OnPart = std::function<void(MjpegPart)>;

  MjpegParser(std::string_view boundary, const MjpegParserOptions& options, OnPart on_part);

  // Takes bytes that arrived at stamp_ns; false when the stream must be given up.
  bool Feed(std::string_view bytes, int64_t stamp_ns);

  MjpegFault Fault() const { return fault_; }
  uint64_t NumSkippedParts() const { return num_skipped_parts_; }

 private:
  enum class State { kJunk, kHeader, kBody };
  struct Arrival {
    size_t end = 0;  // in buffer_: the bytes before it, behind the former's end
    int64_t stamp_ns = 0;
  };

  bool Step();
  bool SkipJunk();
  bool ReadHeaderLine();
  bool AcceptHeaderLine(std::string_view line);
  bool ReadBody();
  bool ReadBodyOfKnownLength();
  void EmitBody(size_t length);
  void StartPart(size_t delimiter_at);
  void Discard(size_t count);
  size_t FindDelimiter();
  bool FailStream(MjpegFault fault);

  const std::string delimiter_;  // "--" and the boundary
  const MjpegParserOptions options_;
  const OnPart on_part_;
  State state_ = State::kJunk;
  MjpegFault fault_ = MjpegFault::kNone;
  std::string buffer_;
  size_t searched_ = 0;           // no delimiter begins before this place of buffer_
  std::deque<Arrival> arrivals_;  // of the bytes in buffer_, one per Feed
  int64_t part_stamp_ns_ = 0;
  size_t junk_bytes_ = 0;
  size_t header_bytes_ = 0;
  size_t header_lines_ = 0;
  bool is_image_ = true;
  std::optional<size_t> content_length_;
  uint64_t num_skipped_parts_ = 0;
};

}  // namespace rovio_sfm
