#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/match.h"

namespace rovio_sfm {

// Every edge of the graph is one of these types. Stamps are nanoseconds since the epoch.

// Into the frontend: an encoded image with what is known about the camera at its stamp.
struct ImageEvent {
  int64_t stamp_ns = 0;
  std::string name;                                     // file name or sequence number, for people
  std::string camera_frame;                             // tf frame of the camera; empty: none
  std::shared_ptr<const std::vector<uint8_t>> encoded;  // JPEG or PNG bytes
  Camera camera;
  std::optional<OdometrySample> odometry;  // interpolated at the stamp
  std::optional<Rigid3> base_from_camera;  // of the head, at the stamp; metres
};

// Two published tracks that a later match has joined; ids already published never change.
struct TrackLink {
  TrackId a = 0;
  TrackId b = 0;
};

// From the frontend to mapping and place recognition: one accepted image.
struct FrameEvent {
  static constexpr uint32_t kFormatVersion = 1;

  FrameId id;
  FrameKind kind = FrameKind::kKeyframe;
  int64_t stamp_ns = 0;
  std::string image_name;
  std::string camera_frame;  // tf frame of the camera; empty: none
  Camera camera;
  std::shared_ptr<const FrameFeatures> features;  // never null; light frames: no descriptors
  std::vector<TrackId> tracks;                    // one per keypoint, 0 for none
  std::vector<PairMatches> pairs;                 // nearest earlier keyframe first; empty if light
  std::vector<TrackLink> links;
  std::optional<OdometrySample> odometry;
  std::optional<Rigid3> base_from_camera;
  double blur = 0.0;  // sharpness score of §5.1.2, higher is sharper
  std::shared_ptr<const std::vector<uint8_t>> jpeg;  // only with keep_images
};

}  // namespace rovio_sfm
