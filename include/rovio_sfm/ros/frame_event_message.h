#pragma once

#include <rovio_sfm/FrameEventMsg.h>

#include <optional>
#include <string>

#include "rovio_sfm/scene/events.h"

namespace rovio_sfm {

// An event as it goes over the wire. Distances and ratios of matches stay behind, and so do angles,
// responses and colours of light frames: nobody downstream uses them.
FrameEventMsg ToMessage(const FrameEvent& event);

// The event of a message; its normalised keypoints are computed anew from the pixels. Nothing where
// the message is malformed: `error` names the field and what was expected.
std::optional<FrameEvent> FromMessage(const FrameEventMsg& message, std::string* error);

}  // namespace rovio_sfm
