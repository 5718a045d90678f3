#pragma once

#include <rovio_sfm/PlaceMatchMsg.h>

#include <optional>
#include <string>

#include "rovio_sfm/scene/place_match.h"

namespace rovio_sfm {

// A match as it goes over the wire; distances and ratios of its feature matches stay behind.
// stamp_ns is that of the query's image.
PlaceMatchMsg ToMessage(const PlaceMatch& match, int64_t stamp_ns);

// The match of a message; nothing where it is malformed: `error` names the field and what was
// expected. Whether the features exist only the frames can tell.
std::optional<PlaceMatch> FromMessage(const PlaceMatchMsg& message, std::string* error);

}  // namespace rovio_sfm
