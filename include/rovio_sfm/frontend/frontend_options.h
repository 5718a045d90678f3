#pragma once

#include <cstdint>
#include <string>

#include "rovio_sfm/features/denoise.h"
#include "rovio_sfm/features/extract_options.h"
#include "rovio_sfm/frontend/choose_keyframe.h"
#include "rovio_sfm/frontend/light_tracks.h"
#include "rovio_sfm/frontend/match_recursively.h"
#include "rovio_sfm/tracks/track_builder.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// Everything that a frontend can be told; config/frontend.yaml mirrors it.
struct FrontendOptions {
  int max_pixels = 32'000'000;
  int min_features = 20;
  bool keep_images = false;
  ChooseOptions choose;
  DenoiseOptions denoise;
  ExtractOptions extract;
  PairOptions pair;
  RecursionOptions recursion;
  TrackOptions track;
  LightOptions light;

  void DescribeOptions(OptionTable& table) {
    table.AddNumber("max_pixels", max_pixels, 1e4, 1e9, "larger images are refused undecoded");
    table.AddLiveNumber("min_features", min_features, 0, 10000, "images with fewer are dropped");
    table.AddFlag("keep_images", keep_images, "the encoded image rides in its event");
    table.AddGroup("choose", choose, "which images become keyframes");
    table.AddGroup("denoise", denoise, "bilateral filter");
    table.AddGroup("extract", extract, "what is found in an image (§3.3)");
    table.AddGroup("pair", pair, "what the matches of a pair pass, in order");
    table.AddGroup("recursion", recursion, "which earlier keyframes are matched");
    table.AddGroup("track", track, "");
    table.AddRule("track.remembered_frames", track.remembered_frames >= recursion.max_frames,
                  "at least recursion.max_frames");
    table.AddGroup("light", light, "frames that follow the last keyframe's features by flow");
  }
};

// Whether `next` may take over from `now` within a drive: it is valid, and what earlier frames of
// the drive were built with (descriptor type, keyframe mode, light frames and their pyramids)
// stays. Otherwise error, which may be null, names the option.
bool MayFollow(const FrontendOptions& now, const FrontendOptions& next, std::string* error);

}  // namespace rovio_sfm
