#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/matching/match_pair.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/ids.h"
#include "rovio_sfm/scene/place_match.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// When appearance and geometry together say that two frames show one place.
struct VerifyPlaceOptions {
  // Stricter than between neighbouring frames: ratio 0.8 and 20 inliers refused every foreign room.
  PairOptions pair = DefaultPair();
  int glance_features = 2000;
  int min_cells = 4;
  int max_neighbors = 2;

  static PairOptions DefaultPair();

  void DescribeOptions(OptionTable& table) {
    table.AddGroup("pair", pair, "what the matches of a pair pass, in order");
    table.AddNumber("glance_features", glance_features, 100, 100000,
                    "the largest, matched first; what they do not hold is not matched whole");
    table.AddNumber("min_cells", min_cells, 1, 16, "of 4 x 4 in each image that hold an inlier");
    table.AddNumber("max_neighbors", max_neighbors, 0, 50, "frames tried on each side (§4.3.1)");
  }
};

// A keyframe with what its verification needs.
struct PlaceFrame {
  FrameId id;
  std::shared_ptr<const FrameFeatures> features;  // never null
  Camera camera;
};

enum class PlaceRefusal : uint8_t { kNone = 0, kGeometry = 1, kSpread = 2 };

// The pair is meaningful where the refusal is kNone.
struct PlaceVerification {
  PlaceRefusal refusal = PlaceRefusal::kGeometry;
  OverlapPair pair;
};

// Looks a frame up by its id; nothing where its features are out of reach.
using FindPlaceFrame = std::function<std::optional<PlaceFrame>(const FrameId&)>;

// Matches a candidate with the query: a glance at the largest features of images with more, then
// all: descriptors, ratio, RANSAC on the essential matrix, spread. Randomness depends on the seed
// and the two ids alone.
PlaceVerification VerifyPlace(const PlaceFrame& candidate, const PlaceFrame& query,
                              const VerifyPlaceOptions& options, uint64_t seed);

// Recursive matching around an overlap (§4.3.1): walks from the matched frame in one direction,
// nearest first, until a pair fails, a frame is out of reach or max_neighbors were tried.
std::vector<OverlapPair> MatchAround(const std::vector<FrameId>& neighbors, const PlaceFrame& query,
                                     const FindPlaceFrame& find, const VerifyPlaceOptions& options,
                                     uint64_t seed);

}  // namespace rovio_sfm
