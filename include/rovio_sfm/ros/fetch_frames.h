#pragma once

#include <rovio_sfm/FrameEventMsg.h>
#include <rovio_sfm/GetFrames.h>

#include <cstdint>
#include <functional>

#include "rovio_sfm/scene/events.h"

namespace rovio_sfm {

// One call of the service get_frames; false if it could not be made.
using CallGetFrames = std::function<bool(GetFramesRequest&, GetFramesResponse&)>;
using HandleFrame = std::function<void(const FrameEventMsg&, const FrameEvent&)>;

// Asks for the frames of a drive from `first` to before `end`, in pages, and hands on those that
// are well-formed and asked for, by rising index. Returns the index after the last one handed on
// (first.index if none was): what the other side does not hold stays missing.
uint32_t FetchFrames(const CallGetFrames& call, const FrameId& first, uint32_t end,
                     const HandleFrame& handle);

// As FetchFrames, of a node that may not have taken all that the caller has heard of: asked again,
// with a pause before, until it holds frame `end` itself, does not answer, or `pause` says false.
// What is missing then was never there.
uint32_t FetchFramesOfFollower(const CallGetFrames& call, const FrameId& first, uint32_t end,
                               const HandleFrame& handle, const std::function<bool()>& pause);

}  // namespace rovio_sfm
