#include "rovio_sfm/sim/http/capture_loop.h"

#include <utility>

namespace rovio_sfm::sim {

bool CaptureOnce(ServerContext& context) {
  const int64_t now = context.robot.now_ns();
  const bool is_stalled =
      context.quirks.With([now](Quirks& quirks) { return quirks.IsActive(Quirk::kStall, now); });
  if (is_stalled) return false;
  const CameraSettings settings = context.settings.Copy().applied;
  const uint64_t number = context.frames.BeginCapture();
  auto image = context.robot.Capture(settings);
  if (!image) return false;
  const bool is_cut =
      context.quirks.With([](Quirks& quirks) { return quirks.Strikes(Quirk::kTruncateJpeg); });
  if (is_cut) image->jpeg.resize(image->jpeg.size() / 2);
  context.frames.Publish(number, std::move(image->jpeg));
  return true;
}

void RunCaptureLoop(ServerContext& context) {
  while (context.frames.WaitForDemand()) {
    const int rate_hz = context.settings.Copy().applied.frame_rate_hz;
    const int64_t period_ns = 1'000'000'000 / rate_hz;
    const int64_t now = context.robot.now_ns();
    const int64_t next_ns = (now / period_ns + 1) * period_ns;
    if (context.stop.WaitFor(std::chrono::nanoseconds(next_ns - now))) return;
    CaptureOnce(context);
  }
}

}  // namespace rovio_sfm::sim
