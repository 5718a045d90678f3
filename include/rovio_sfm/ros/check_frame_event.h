#pragma once

#include <rovio_sfm/FrameEventMsg.h>

#include <string>

namespace rovio_sfm {

// True if the sizes, numbers and indices of an event agree with each other (hardening: messages are
// untrusted). Else `error` names the field. Does not undistort: FromMessage does that.
bool IsConsistent(const FrameEventMsg& message, std::string* error);

}  // namespace rovio_sfm
