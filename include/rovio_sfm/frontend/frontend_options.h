#pragma once

#include <cstdint>
#include <string>

#include "rovio_sfm/features/denoise.h"
#include "rovio_sfm/features/extract_options.h"
#include "rovio_sfm/frontend/choose_keyframe.h"
#include "rovio_sfm/frontend/light_tracks.h"
#include "rovio_sfm/frontend/match_recursively.h"
#include "rovio_sfm/tracks/track_builder.h"

namespace rovio_sfm {

// Everything that a frontend can be told; config/frontend.yaml mirrors it.
struct FrontendOptions {
  int max_pixels = 32'000'000;  // larger images are refused before decoding; 1e4 to 1e9
  int min_features = 20;        // images with fewer are dropped; 0 to 10000
  bool keep_images = false;     // the encoded image rides in its event
  ChooseOptions choose;
  DenoiseOptions denoise;
  ExtractOptions extract;
  PairOptions pair;
  RecursionOptions recursion;
  TrackOptions track;
  LightOptions light;

  // Names option, value and bound of the first that does not fit.
  bool IsValid(std::string* error) const;
};

// Whether `next` may take over from `now` within a drive: it is valid, and what earlier frames of
// the drive were built with (descriptor type, keyframe mode, light frames and their pyramids)
// stays. Otherwise error, which may be null, names the option.
bool MayFollow(const FrontendOptions& now, const FrontendOptions& next, std::string* error);

}  // namespace rovio_sfm
