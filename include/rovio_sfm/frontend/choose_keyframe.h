#pragma once

#include <cstdint>
#include <deque>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/features/flow.h"
#include "rovio_sfm/geometry/camera.h"

namespace rovio_sfm {

enum class KeyframeMode : uint8_t {
  kEvery,     // stop-and-shoot: every image that is not spoilt
  kParallax,  // video: by parallax, rotation or overlap lost
};

// Which images become keyframes (§6.2 lists the choice as missing).
struct ChooseOptions {
  KeyframeMode mode = KeyframeMode::kEvery;
  int num_corners = 200;          // followed at half size; 20 to 2000
  double min_flow_rad = 0.02;     // median flow without its rotation; 0.001 to 1
  double min_rotation_rad = 0.1;  // since the keyframe; 0.01 to 1
  double min_tracked_share =
      0.7;  // fewer of the keyframe's corners left: overlap is being lost; 0 to 1
  // Sharpness below this share of the drive's running median delays a keyframe; 0 to 1.
  double blurred_share = 0.7;
  double spoilt_share = 0.2;  // below it the image is dropped; 0 to blurred_share
  int max_delay = 8;          // images a blurred keyframe may be put off; 0 to 100
  int sharpness_window = 31;  // images of the running median; 1 to 1000

  bool IsValid(std::string* error) const;
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
