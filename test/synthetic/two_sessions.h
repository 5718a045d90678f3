#pragma once

#include "synthetic/synthetic_session.h"

namespace rovio_sfm {

struct TwoSessionsOptions {
  SyntheticOptions world = DefaultWorld();
  Sim3 b_from_a{1.7, Eigen::Quaterniond(0.8, 0.2, -0.5, 0.1).normalized(), {3.0, -2.0, 5.0}};
  double sigma_log_distance = 0.0;  // error of each landmark's distance from its session's camera 0

  // 8 cameras that move sideways, 0.2 map units each, past 300 points at about 4.
  static SyntheticOptions DefaultWorld();
};

// Two mapped sessions of one world in two gauges, of two drives: a has the world's even cameras as
// keyframes 0, 1, …, b the odd ones. Their features and tracks are those of world_a and world_b.
struct TwoSessions {
  SyntheticWorld world_a, world_b;
  Sim3 b_from_a;
  Session a, b;
};

TwoSessions MakeTwoSessions(const TwoSessionsOptions& options);

// The true matches between keyframes of a and b, and so large a share of false ones, shuffled.
std::vector<FeatureMatch> CrossFeatureMatches(const TwoSessions& sessions, uint32_t keyframe_a,
                                              uint32_t keyframe_b, double outlier_share, Rng& rng);

// How far apart two similarities are: rotation in rad, |log of the scales' ratio|, and distance of
// the images of a point, by the second's scale.
double SimilarityDistance(const Sim3& b_from_a, const Sim3& other_b_from_a,
                          const Eigen::Vector3d& x_in_a);

}  // namespace rovio_sfm
