#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "rovio_sfm/rovio/back_off.h"
#include "rovio_sfm/rovio/http_transport.h"
#include "rovio_sfm/rovio/mjpeg_parser.h"
#include "rovio_sfm/rovio/reader_gate.h"
#include "rovio_sfm/rovio/rovio_client.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

enum class ImageSource { kAuto, kStream, kStills };  // kAuto: the stream, stills while it fails

struct ImageReaderOptions {
  ImageSource source = ImageSource::kAuto;
  MjpegParserOptions parser;
  uint64_t max_pixels = 1024 * 1024;
  int max_stream_failures = 2;
  double max_image_gap_s = 3.0;
  double stream_retry_period_s = 20.0;
  BackOffOptions back_off;

  // The group "images"; back_off is one for all that the driver asks of the robot.
  void DescribeOptions(OptionTable& table) {
    table.AddChoice("source", source,
                    {{"auto", ImageSource::kAuto},
                     {"stream", ImageSource::kStream},
                     {"stills", ImageSource::kStills}},
                    "auto: the stream, stills while it fails");
    table.AddNumber("max_bytes", parser.max_part_bytes, 1024, 1e9, "a Rovio's stay below 64 KiB");
    table.AddNumber("max_pixels", max_pixels, 1024, 1e9, "");
    table.AddNumber("max_stream_failures", max_stream_failures, 1, 1000, "then stills stand in …");
    table.AddNumber("max_image_gap_s", max_image_gap_s, 0.5, 600.0, "of bytes without an image");
    table.AddNumber("stream_retry_period_s", stream_retry_period_s, 1.0, 86400.0, "… for so long");
  }
};

// A whole image as the robot encoded it.
struct CameraImage {
  int64_t stamp_ns = 0;  // of its first byte, by the clock of stamps; rises but where that jumps
  int64_t first_byte_ns = 0;  // the same, steady
  int64_t complete_ns = 0;    // when its last byte was here, steady
  int width_px = 0;
  int height_px = 0;
  std::string jpeg;
};

enum class ImageLink { kConnecting, kStream, kStills, kDown };
const char* NameOf(ImageLink link);

// Counts since the start; each may be read from any thread.
struct ImageCounters {
  std::atomic<uint64_t> num_images{0};
  std::atomic<uint64_t> num_truncated{0};   // no end marker
  std::atomic<uint64_t> num_corrupt{0};     // any other fault of a JPEG
  std::atomic<uint64_t> num_too_large{0};   // bytes or pixels above a cap
  std::atomic<uint64_t> num_malformed{0};   // streams and answers that were no HTTP or multipart
  std::atomic<uint64_t> num_failures{0};    // attempts that ended in a fault
  std::atomic<uint64_t> num_reconnects{0};  // images came again after a failure
};

// Fetches images until its gate is stopped: stream first, stills as a fallback, back-off between
// attempts that fail. Damaged images are counted and dropped. Run() belongs on a thread of its own;
// the callbacks are called there. To end it, stop the gate and cancel the transport.
class ImageReader {
 public:
  struct Callbacks {
    std::function<void(CameraImage)> on_image;
    // At each change of the link, with the reason.
    std::function<void(ImageLink, const std::string& reason)> on_link;
    std::function<int64_t()> now_ns;           // of stamps; may jump
    std::function<int64_t()> steady_ns;        // of everything else
    std::function<bool(double seconds)> wait;  // false: stop. Default of the gate when empty
  };

  // Borrows transport and gate; both must outlive it.
  ImageReader(const ImageReaderOptions& options, HttpTransport* transport, ReaderGate* gate,
              Callbacks callbacks);

  void Run();

  const ImageCounters& Counters() const { return counters_; }

 private:
  // One attempt: an empty reason means that it ended for no fault of the robot's.
  std::string ReadStream();
  std::string ReadStills();
  void TakeImage(std::string jpeg, int64_t first_byte_ns, ImageLink link);
  int64_t StampOf(int64_t first_byte_ns) const;
  void CountFault(HttpFault fault);
  void SetLink(ImageLink link, const std::string& reason);
  bool UsesStream() const;
  bool MayGoOnWithStills() const;
  void NoteFailure(bool was_stream);

  const ImageReaderOptions options_;
  HttpTransport* const transport_;
  ReaderGate* const gate_;
  const Callbacks callbacks_;
  RovioClient client_;
  BackOff back_off_;
  ImageCounters counters_;
  ImageLink link_ = ImageLink::kConnecting;
  bool has_failed_ = false;
  uint64_t num_images_before_ = 0;  // when the present attempt began
  bool is_stream_suspect_ = false;  // gave no image, where stills might
  int num_stream_failures_ = 0;
  int64_t stills_until_ns_ = INT64_MIN;  // steady
  int64_t last_stamp_ns_ = INT64_MIN;
  int64_t last_image_ns_ = 0;  // steady: when the newest image was here, or the stream began
};

}  // namespace rovio_sfm
