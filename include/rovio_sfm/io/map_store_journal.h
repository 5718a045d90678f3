#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "rovio_sfm/io/map_store_database.h"
#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/scene/session_journal.h"

namespace rovio_sfm {

// How keyframes and light frames are made of their events; poses and tracks are set later.
struct FrameMaker {
  std::function<Keyframe(const FrameEvent&)> keyframe;
  std::function<LightFrame(const FrameEvent&)> light_frame;
};

// The event of a session's frame.
using EventOf = std::function<FrameEvent(uint32_t)>;

// How many entries of each list of an epoch are kept already: lists only grow.
using EpochSizes = std::array<size_t, 8>;
EpochSizes SizesOf(const SessionEpoch& epoch);

// The entries that came since `from`, and those of several such parts put together again.
std::string EpochBytes(const SessionEpoch& epoch, const EpochSizes& from);
void ReadEpoch(const Blob& bytes, const FrameMaker& make, const EventOf& event_of,
               SessionEpoch* epoch);

}  // namespace rovio_sfm
