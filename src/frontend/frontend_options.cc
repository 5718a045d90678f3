#include "rovio_sfm/frontend/frontend_options.h"

#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm {

bool FrontendOptions::IsValid(std::string* error) const {
  OptionChecker checker("frontend", error);
  checker.Range("max_pixels", max_pixels, 10'000, 1'000'000'000);
  checker.Range("min_features", min_features, 0, 10'000);
  checker.Nested(choose);
  checker.Nested(denoise);
  checker.Nested(extract);
  checker.Nested(pair);
  checker.Nested(recursion);
  checker.Nested(track);
  checker.Nested(light);
  checker.True("track.remembered_frames", track.remembered_frames >= recursion.max_frames,
               "at least recursion.max_frames");
  return checker.Passed();
}

bool MayFollow(const FrontendOptions& now, const FrontendOptions& next, std::string* error) {
  constexpr const char* kSame = "no change while the frontend runs";
  OptionChecker checker("frontend", error);
  checker.Nested(next);
  checker.True("extract.type", next.extract.type == now.extract.type, kSame);
  checker.True("choose.mode", next.choose.mode == now.choose.mode, kSame);
  checker.True("light.enabled", next.light.enabled == now.light.enabled, kSame);
  checker.True("light.flow.window_px", next.light.flow.window_px == now.light.flow.window_px,
               kSame);
  checker.True("light.flow.levels", next.light.flow.levels == now.light.flow.levels, kSame);
  return checker.Passed();
}

}  // namespace rovio_sfm
