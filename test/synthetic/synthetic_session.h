#pragma once

#include "rovio_sfm/scene/session.h"
#include "rovio_sfm/util/rng.h"
#include "synthetic/synthetic_world.h"

namespace rovio_sfm {

// The track of a world's point: its index + 1.
inline TrackId TrackOfPoint(uint32_t point) { return point + 1; }

// A camera of the world as a keyframe at its true pose: all features, sigma one pixel.
Keyframe MakeSyntheticKeyframe(const SyntheticWorld& world, size_t cam);

// A session that holds the cameras as keyframes 0, 1, … at their true poses; no landmarks.
Session MakeSyntheticSession(const SyntheticWorld& world);

// The same with the true landmark of every point that two or more cameras see.
Session MakeMappedSession(const SyntheticWorld& world);

// A pose turned and moved by Gaussian steps of these standard deviations per axis.
Rigid3 PerturbPose(const Rigid3& cam_from_map, double sigma_rad, double sigma, Rng& rng);

// How far apart two poses are: rotation in rad plus distance of the centres.
double PoseDistance(const Rigid3& cam_from_map_a, const Rigid3& cam_from_map_b);

}  // namespace rovio_sfm
