#pragma once

#include <utility>

#include "rovio_sfm/scene/map_snapshot.h"

namespace rovio_sfm {

inline LandmarkSnapshot SmallLandmark(TrackId id, uint32_t num_views, double error_normalized) {
  LandmarkSnapshot landmark;
  landmark.id = id;
  landmark.position = {0.1 * static_cast<double>(id), 0.0, 2.0};
  landmark.num_views = num_views;
  landmark.max_parallax_rad = 0.1;
  landmark.mean_error_px = 500.0 * error_normalized;
  landmark.squared_error_normalized = num_views * error_normalized * error_normalized;
  return landmark;
}

// A session of num_frames cameras along x (camera right), half a unit apart, the last one weak,
// that sees the landmarks; its map is its own.
inline SessionSnapshot SmallSession(uint32_t id, uint32_t num_frames, LandmarkBlock landmarks) {
  SessionSnapshot session;
  session.id = {id};
  session.map = {id};
  session.drive = {"rovio", 1, id};
  session.camera.fx = session.camera.fy = 500.0;
  session.camera.cx = 320.0, session.camera.cy = 240.0;
  session.camera.width = 640, session.camera.height = 480;
  session.given_camera = session.camera;
  FrameBlock frames(num_frames);
  for (uint32_t i = 0; i < num_frames; ++i) {
    frames[i].index = i;
    frames[i].stamp_ns = i * 100'000'000;
    frames[i].kind = i % 2 == 0 ? FrameKind::kKeyframe : FrameKind::kLight;
    frames[i].weak = i + 1 == num_frames;
    frames[i].cam_from_session.translation = {-0.5 * i, 0.0, 0.0};
  }
  session.frames = {std::make_shared<const FrameBlock>(std::move(frames))};
  session.landmarks = {std::make_shared<const LandmarkBlock>(std::move(landmarks))};
  return session;
}

}  // namespace rovio_sfm
