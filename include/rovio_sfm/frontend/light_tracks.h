#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "rovio_sfm/features/flow.h"
#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/ids.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// Light frames: the last keyframe's features followed by flow (§5.1.2).
struct LightOptions {
  bool enabled = true;
  int max_features = 250;
  int min_features = 20;
  FlowOptions flow;

  void DescribeOptions(OptionTable& table) {
    table.AddFlag("enabled", enabled, "false: images that are no keyframes give no event");
    table.AddLiveNumber("max_features", max_features, 10, 2000,
                        "followed after a keyframe; at 250 the event stays below 10 kB");
    table.AddLiveNumber("min_features", min_features, 1, 2000, "fewer give no light frame");
    table.AddRule("min_features", min_features <= max_features, "at most max_features");
    table.AddGroup("flow", flow, "");
  }
};

struct LightFeatures {
  FrameFeatures features;       // no descriptors
  std::vector<TrackId> tracks;  // of the keyframe's features, one per keypoint
};

// Follows features of a keyframe through the images after it, each time against the keyframe's own
// patch, so that drift does not add up; the last position is only the guess. Not thread-safe.
class LightTracks {
 public:
  explicit LightTracks(const LightOptions& options) : options_(options) {}

  // From the next image on (max_features: from the next keyframe); the pyramids must stay.
  void SetOptions(const LightOptions& options) { options_ = options; }

  // Begins anew at this keyframe. preferred marks features worth following first (matched ones).
  void StartFrom(const FlowPyramid& image, std::shared_ptr<const FrameFeatures> features,
                 const std::vector<TrackId>& tracks, const std::vector<bool>& preferred);
  // The features that are seen in this image, the next after the last one given.
  LightFeatures Follow(const FlowPyramid& image, const Camera& camera);

 private:
  LightOptions options_;
  FlowPyramid keyframe_;
  std::shared_ptr<const FrameFeatures> features_;
  std::vector<TrackId> tracks_;
  std::vector<size_t> chosen_;            // indices into features_
  std::vector<cv::Point2f> in_keyframe_;  // of the chosen
  std::vector<cv::Point2f> guess_;        // of the chosen, in the next image
};

}  // namespace rovio_sfm
