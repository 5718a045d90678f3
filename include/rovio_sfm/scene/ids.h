#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <tuple>

namespace rovio_sfm {

// The images of one frontend from its start to its end. Created by the frontend alone.
struct DriveId {
  std::string robot;     // [a-z][a-z0-9_]*, at most 32 characters
  int64_t start_ns = 0;  // stamp of the drive's first image
  uint32_t nonce = 0;    // random live, a checksum of the first image in replay

  std::string ToString() const;  // robot-start_ns-nonce
};

// A frame for ever: drive and index without gaps, both keyframes and light frames; never
// renumbered.
struct FrameId {
  DriveId drive;
  uint32_t index = 0;

  std::string ToString() const;  // drive/index
};

// A track of one drive, counted from 1 by its frontend; 0 means "no track". The landmark of a track
// has the same id.
using TrackId = uint64_t;

// A session: consecutive frames of one drive in one gauge; numbered by the mapper alone, from 1.
struct SessionId {
  uint32_t value = 0;
};

// A map: sessions that share one gauge; named after its root session.
struct MapId {
  uint32_t value = 0;
};

inline bool operator==(const DriveId& a, const DriveId& b) {
  return std::tie(a.robot, a.start_ns, a.nonce) == std::tie(b.robot, b.start_ns, b.nonce);
}
inline bool operator!=(const DriveId& a, const DriveId& b) { return !(a == b); }
inline bool operator<(const DriveId& a, const DriveId& b) {
  return std::tie(a.start_ns, a.robot, a.nonce) < std::tie(b.start_ns, b.robot, b.nonce);
}
inline bool operator==(const FrameId& a, const FrameId& b) {
  return a.index == b.index && a.drive == b.drive;
}
inline bool operator!=(const FrameId& a, const FrameId& b) { return !(a == b); }
inline bool operator<(const FrameId& a, const FrameId& b) {
  return std::tie(a.drive, a.index) < std::tie(b.drive, b.index);
}
inline bool operator==(SessionId a, SessionId b) { return a.value == b.value; }
inline bool operator!=(SessionId a, SessionId b) { return a.value != b.value; }
inline bool operator<(SessionId a, SessionId b) { return a.value < b.value; }
inline bool operator==(MapId a, MapId b) { return a.value == b.value; }
inline bool operator<(MapId a, MapId b) { return a.value < b.value; }

// True if the name is a valid robot name; else error says what was expected.
bool IsValidRobotName(const std::string& name, std::string* error);

}  // namespace rovio_sfm
