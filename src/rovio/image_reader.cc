#include "rovio_sfm/rovio/image_reader.h"

#include <algorithm>
#include <utility>

#include "rovio_sfm/scene/stamp_order.h"
#include "rovio_sfm/util/jpeg_check.h"

namespace rovio_sfm {
namespace {

constexpr double kNanosecondsPerSecond = 1e9;

int64_t Nanoseconds(double seconds) {
  return static_cast<int64_t>(seconds * kNanosecondsPerSecond);
}

std::string ReasonOf(const HttpResponse& response, const MjpegParser* parser) {
  if (parser != nullptr && parser->Fault() != MjpegFault::kNone) {
    return std::string("stream: ") + NameOf(parser->Fault());
  }
  if (response.status == 401) return "stream: login refused (401)";
  if (response.status != 0 && response.status != 200) {
    return "stream: HTTP status " + std::to_string(response.status);
  }
  if (response.fault != HttpFault::kNone && response.fault != HttpFault::kCancelled) {
    return std::string("stream: ") + NameOf(response.fault) + ": " + response.message;
  }
  return parser == nullptr ? "stream: no multipart answer" : "stream: ended by the robot";
}

}  // namespace

const char* NameOf(ImageLink link) {
  switch (link) {
    case ImageLink::kConnecting:
      return "connecting";
    case ImageLink::kStream:
      return "stream";
    case ImageLink::kStills:
      return "stills";
    case ImageLink::kDown:
      return "down";
  }
  return "unknown";
}

ImageReader::ImageReader(const ImageReaderOptions& options, HttpTransport* transport,
                         ReaderGate* gate, Callbacks callbacks)
    : options_(options),
      transport_(transport),
      gate_(gate),
      callbacks_(std::move(callbacks)),
      client_(transport),
      back_off_(options.back_off) {}

void ImageReader::Run() {
  while (gate_->WaitUntilOpen()) {
    num_images_before_ = counters_.num_images;
    const bool is_stream = UsesStream();
    const std::string reason = is_stream ? ReadStream() : ReadStills();
    if (gate_->IsStopped()) return;
    if (reason.empty()) continue;
    NoteFailure(is_stream);
    SetLink(ImageLink::kDown, reason);
    const double delay_s = back_off_.NextDelaySeconds();
    if (callbacks_.wait ? !callbacks_.wait(delay_s) : !gate_->WaitFor(delay_s)) return;
  }
}

bool ImageReader::UsesStream() const {
  if (options_.source != ImageSource::kAuto) return options_.source == ImageSource::kStream;
  return callbacks_.steady_ns() >= stills_until_ns_;
}

void ImageReader::NoteFailure(bool was_stream) {
  ++counters_.num_failures;
  has_failed_ = true;
  if (counters_.num_images != num_images_before_) num_stream_failures_ = 0;
  if (!was_stream || !is_stream_suspect_) return;
  if (++num_stream_failures_ < options_.max_stream_failures) return;
  num_stream_failures_ = 0;
  stills_until_ns_ = callbacks_.steady_ns() + Nanoseconds(options_.stream_retry_period_s);
}

std::string ImageReader::ReadStream() {
  std::optional<MjpegParser> parser;
  const auto on_header = [&](int status, const std::string& content_type) {
    const std::optional<std::string> boundary = BoundaryOf(content_type);
    if (status != 200 || !boundary) return false;
    parser.emplace(*boundary, options_.parser, [this](MjpegPart part) {
      TakeImage(std::move(part.body), part.stamp_ns, ImageLink::kStream);
    });
    return true;
  };
  last_image_ns_ = callbacks_.steady_ns();
  bool is_idle = false;
  const auto on_bytes = [&](std::string_view bytes) {
    const int64_t now_ns = callbacks_.steady_ns();
    if (!parser->Feed(bytes, now_ns)) return false;
    is_idle = now_ns - last_image_ns_ > Nanoseconds(options_.max_image_gap_s);
    return !is_idle;
  };
  const HttpResponse response = transport_->Stream(StreamTarget(), {on_header, on_bytes});
  const MjpegFault fault = parser ? parser->Fault() : MjpegFault::kNone;
  if (fault == MjpegFault::kPartTooLong) {
    ++counters_.num_too_large;
  } else if (fault != MjpegFault::kNone) {
    ++counters_.num_malformed;
  }
  CountFault(response.fault);
  const bool would_stills_fail = response.fault == HttpFault::kConnect || response.status == 401;
  is_stream_suspect_ = !would_stills_fail && counters_.num_images == num_images_before_;
  if (is_idle) return "stream: bytes, but no image";
  return ReasonOf(response, parser ? &*parser : nullptr);
}

std::string ImageReader::ReadStills() {
  while (MayGoOnWithStills()) {
    if (!gate_->WaitUntilOpen()) return {};
    RobotReply<StillImage> still = client_.GetStill(options_.parser.max_part_bytes);
    if (!still.value) return "stills: " + still.outcome.message;
    const uint64_t num_before = counters_.num_images;
    TakeImage(std::move(still.value->jpeg),
              callbacks_.steady_ns() - Nanoseconds(still.value->age_s), ImageLink::kStills);
    if (counters_.num_images == num_before) return "stills: damaged image";
  }
  return {};
}

bool ImageReader::MayGoOnWithStills() const {
  return options_.source == ImageSource::kStills || callbacks_.steady_ns() < stills_until_ns_;
}

void ImageReader::TakeImage(std::string jpeg, int64_t first_byte_ns, ImageLink link) {
  const JpegInfo info = CheckJpeg(jpeg, options_.max_pixels);
  if (info.fault != JpegFault::kNone) {
    const bool is_truncated = info.fault == JpegFault::kNoEnd;
    const bool is_too_large = info.fault == JpegFault::kTooManyPixels;
    ++(is_truncated   ? counters_.num_truncated
       : is_too_large ? counters_.num_too_large
                      : counters_.num_corrupt);
    return;
  }
  if (has_failed_) ++counters_.num_reconnects;
  has_failed_ = false;
  back_off_.Reset();
  ++counters_.num_images;
  SetLink(link, "images arrive");
  jpeg.resize(info.num_bytes);
  last_stamp_ns_ = StampOf(first_byte_ns);
  last_image_ns_ = callbacks_.steady_ns();
  callbacks_.on_image({last_stamp_ns_, first_byte_ns, last_image_ns_, info.width_px, info.height_px,
                       std::move(jpeg)});
}

// Stamps rise but where the clock jumps back: then all that is stamped does so together.
int64_t ImageReader::StampOf(int64_t first_byte_ns) const {
  const int64_t stamp_ns = callbacks_.now_ns() - (callbacks_.steady_ns() - first_byte_ns);
  const bool is_late = OrderOf(stamp_ns, last_stamp_ns_) == StampOrder::kLate;
  return is_late ? last_stamp_ns_ + 1 : stamp_ns;
}

void ImageReader::CountFault(HttpFault fault) {
  if (fault == HttpFault::kTooLarge) ++counters_.num_too_large;
  if (fault == HttpFault::kMalformed) ++counters_.num_malformed;
}

void ImageReader::SetLink(ImageLink link, const std::string& reason) {
  if (link == link_) return;
  link_ = link;
  callbacks_.on_link(link, reason);
}

}  // namespace rovio_sfm
