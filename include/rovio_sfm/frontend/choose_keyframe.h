#pragma once

#include <cstdint>
#include <deque>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/features/flow.h"
#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

enum class KeyframeMode : uint8_t {
  kEvery,     // stop-and-shoot: every image that is not spoilt
  kParallax,  // video: by parallax, rotation or overlap lost
};

// Which images become keyframes (§6.2 lists the choice as missing).
struct ChooseOptions {
  KeyframeMode mode = KeyframeMode::kEvery;
  int num_corners = 200;
  double min_flow_rad = 0.02;
  double min_rotation_rad = 0.1;
  double min_tracked_share = 0.7;
  double blurred_share = 0.7;
  double spoilt_share = 0.2;
  int max_delay = 8;
  int sharpness_window = 31;

  void DescribeOptions(OptionTable& table) {
    table.AddChoice("mode", mode,
                    {{"every", KeyframeMode::kEvery}, {"parallax", KeyframeMode::kParallax}},
                    "every: stop-and-shoot; parallax: video");
    table.AddLiveNumber("num_corners", num_corners, 20, 2000, "followed at half size");
    table.AddLiveNumber("min_flow_rad", min_flow_rad, 0.001, 1.0, "median, without its rotation");
    table.AddLiveNumber("min_rotation_rad", min_rotation_rad, 0.01, 1.0, "since the last keyframe");
    table.AddLiveNumber("min_tracked_share", min_tracked_share, 0.0, 1.0,
                        "of the last keyframe's corners: below, overlap is being lost");
    table.AddLiveNumber("blurred_share", blurred_share, 0.0, 1.0, "of the median: below, put off");
    table.AddLiveNumber("spoilt_share", spoilt_share, 0.0, 1.0, "below, the image is dropped");
    table.AddRule("spoilt_share", spoilt_share <= blurred_share, "at most blurred_share");
    table.AddLiveNumber("max_delay", max_delay, 0, 100, "images a blurred keyframe may be put off");
    table.AddNumber("sharpness_window", sharpness_window, 1, 1000, "images of the running median");
  }
};

// The camera's motion since the last keyframe, as far as a cheap tracker sees it.
struct ImageMotion {
  double flow_rad = 0.0;      // median, after removing the rotation
  double rotation_rad = 0.0;  // of the whole camera
  double tracked_share = 0.0;
};

enum class ImageChoice : uint8_t { kKeyframe, kLight, kSpoilt };

// The rule alone: what becomes of an image. num_delayed counts the blurred images since one should
// have become a keyframe; sharpness_share is its sharpness over the running median.
ImageChoice ChooseImage(const ImageMotion& motion, double sharpness_share, int num_delayed,
                        const ChooseOptions& options);

// Follows a keyframe's corners from image to image at half size. Not thread-safe.
class MotionTracker {
 public:
  explicit MotionTracker(const ChooseOptions& options) : options_(options) {}

  // From the next keyframe on.
  void SetOptions(const ChooseOptions& options) { options_ = options; }

  // How the half-size pyramids are to be built.
  static FlowOptions PyramidOptions();

  // Begins anew at this keyframe. small_image is at half size.
  void StartFrom(const FlowPyramid& small_image);
  // The motion of this image, the next after the last one given.
  ImageMotion Follow(const FlowPyramid& small_image, const Camera& camera);

 private:
  ChooseOptions options_;
  FlowPyramid last_;
  std::vector<cv::Point2f> reference_;  // corners in the keyframe, half-size pixels
  std::vector<cv::Point2f> current_;    // where they are now; same order
  size_t num_started_ = 0;
};

// Chooses image by image. Not thread-safe; depends on nothing but the images given.
class KeyframeChooser {
 public:
  explicit KeyframeChooser(const ChooseOptions& options) : options_(options), tracker_(options) {}

  // From the next image on; the mode must stay.
  void SetOptions(const ChooseOptions& options);

  // The first image is a keyframe unless it is spoilt. small_image may be empty in mode every.
  ImageChoice Choose(const FlowPyramid& small_image, double sharpness, const Camera& camera);
  // The image was to be a keyframe or was made one for another reason: the next are seen from it.
  void StartFrom(const FlowPyramid& small_image);

 private:
  double SharpnessShare(double sharpness);

  ChooseOptions options_;
  MotionTracker tracker_;
  std::deque<double> sharpness_;
  bool has_keyframe_ = false;
  int num_delayed_ = 0;
};

}  // namespace rovio_sfm
