#pragma once

#include <memory>

#include "rovio_sfm/scene/map_snapshot.h"

namespace rovio_sfm {

// A session of three keyframes one unit apart along the camera's view, and two landmarks.
inline SessionSnapshot SmallSession(uint32_t number) {
  SessionSnapshot session;
  session.id = {number};
  session.map = {number};
  session.drive = {"rovio" + std::to_string(number), 5, 6};
  session.camera = {500.0, 500.0, 320.0, 240.0, 0, 0, 0, 0, 0, 640, 480};
  session.state = SessionState::kMapping;
  FrameBlock frames;
  for (uint32_t i = 0; i < 3; ++i) {
    FrameSnapshot frame;
    frame.index = 2 * i;
    frame.stamp_ns = 1000000000 * static_cast<int64_t>(i + 1);
    frame.cam_from_session.translation = Eigen::Vector3d(0.0, 0.0, -1.0 * i);
    frames.push_back(frame);
  }
  session.frames = {std::make_shared<const FrameBlock>(frames)};
  LandmarkBlock landmarks;
  for (uint32_t i = 0; i < 2; ++i) {
    LandmarkSnapshot landmark;
    landmark.id = i + 1;
    landmark.position = Eigen::Vector3d(0.0, -1.0, 5.0);
    landmark.color = {10, 20, 30};
    landmark.num_views = 2 + i;
    landmark.max_parallax_rad = 0.1;
    landmark.mean_error_px = 0.5;
    landmarks.push_back(landmark);
  }
  session.landmarks = {std::make_shared<const LandmarkBlock>(landmarks)};
  return session;
}

inline std::shared_ptr<const MapSnapshot> SmallMaps(uint32_t num_sessions) {
  auto snapshot = std::make_shared<MapSnapshot>();
  snapshot->version = 1;
  for (uint32_t i = 1; i <= num_sessions; ++i) snapshot->sessions.push_back(SmallSession(i));
  return snapshot;
}

}  // namespace rovio_sfm
