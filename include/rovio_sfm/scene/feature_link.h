#pragma once

#include <cstdint>
#include <tuple>

#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {

// A feature of a registered keyframe, whatever happens to its track and landmark.
struct FeatureRef {
  SessionId session;
  uint32_t frame = 0;  // FrameId::index
  uint32_t feature = 0;
};
inline bool operator==(const FeatureRef& a, const FeatureRef& b) {
  return a.session == b.session && a.frame == b.frame && a.feature == b.feature;
}
inline bool operator<(const FeatureRef& a, const FeatureRef& b) {
  return std::tie(a.session, a.frame, a.feature) < std::tie(b.session, b.frame, b.feature);
}

// Two features, of two sessions or of one, that show the same point. Links join sessions without
// changing them (§4.3, a merge is an overlay): tracks and landmarks stay their session's.
struct FeatureLink {
  FeatureRef a;
  FeatureRef b;
};
inline bool operator==(const FeatureLink& x, const FeatureLink& y) {
  return x.a == y.a && x.b == y.b;
}
inline bool operator<(const FeatureLink& x, const FeatureLink& y) {
  return std::tie(x.a, x.b) < std::tie(y.a, y.b);
}

}  // namespace rovio_sfm
