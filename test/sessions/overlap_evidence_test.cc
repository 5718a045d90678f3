#include "rovio_sfm/sessions/overlap_evidence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rovio_sfm/util/check_options.h"
#include "synthetic/synthetic_world.h"

namespace rovio_sfm {
namespace {

// What the first camera of a world sees, all of it an inlier.
OverlapEvidence MakeEvidence(const SyntheticWorld& world) {
  OverlapEvidence evidence;
  evidence.camera = world.camera;
  for (const SyntheticView& view : world.views[0]) {
    const double depth = (world.cams_from_map[0] * world.points[view.point]).z();
    evidence.inliers.push_back({view.x_normalized, depth});
  }
  evidence.num_visible = 100;
  evidence.num_visible_matched = 60;
  return evidence;
}

OverlapEvidence CompleteEvidence() { return MakeEvidence(MakeSyntheticWorld({})); }

SyntheticWorld FlatWorld() {
  SyntheticOptions options;
  options.scene = SyntheticScene::kPlane;
  return MakeSyntheticWorld(options);
}

TEST(JudgeOverlap, AcceptsWhatIsSpreadDeepAndThere) {
  const EvidenceVerdict verdict = JudgeOverlap(CompleteEvidence(), {});
  EXPECT_EQ(verdict.verdict, MergeVerdict::kAccepted) << verdict.text;
  EXPECT_EQ(verdict.reason, EvidenceReason::kComplete);
  EXPECT_EQ(verdict.num_rows, 4);
  EXPECT_EQ(verdict.num_columns, 4);
  EXPECT_NEAR(verdict.matched_share, 0.6, 1e-12);
  EXPECT_GT(verdict.depth_ratio, 2.0);
  EXPECT_GT(verdict.off_plane_share, 0.5);
}

TEST(JudgeOverlap, HoldsBackTooFewInliers) {
  OverlapEvidence evidence = CompleteEvidence();
  evidence.inliers.resize(24);
  EXPECT_EQ(JudgeOverlap(evidence, {}).reason, EvidenceReason::kTooFewInliers);
  evidence.inliers.clear();
  const EvidenceVerdict verdict = JudgeOverlap(evidence, {});
  EXPECT_EQ(verdict.verdict, MergeVerdict::kProvisional);
  EXPECT_EQ(verdict.num_rows, 0);
  EXPECT_EQ(verdict.depth_ratio, 0.0);
}

TEST(JudgeOverlap, HoldsBackInliersInOneCorner) {
  OverlapEvidence evidence = CompleteEvidence();
  for (EvidenceInlier& inlier : evidence.inliers) {
    inlier.x_normalized.x() = -0.3 + 0.3 * inlier.x_normalized.x();
  }
  const EvidenceVerdict verdict = JudgeOverlap(evidence, {});
  EXPECT_EQ(verdict.verdict, MergeVerdict::kProvisional);
  EXPECT_EQ(verdict.reason, EvidenceReason::kNotSpread);
  EXPECT_LT(verdict.num_columns, 3);
  EXPECT_NE(verdict.text.find("columns"), std::string::npos);
}

TEST(JudgeOverlap, HoldsBackInliersInTooFewRows) {
  OverlapEvidence evidence = CompleteEvidence();
  for (EvidenceInlier& inlier : evidence.inliers) {
    inlier.x_normalized.y() = -0.2 + 0.3 * inlier.x_normalized.y();
  }
  EvidenceOptions options;
  const EvidenceVerdict verdict = JudgeOverlap(evidence, options);
  EXPECT_EQ(verdict.reason, EvidenceReason::kNotSpread);
  EXPECT_EQ(verdict.num_columns, 4);
  ASSERT_LT(verdict.num_rows, options.min_rows);
  options.min_rows = verdict.num_rows;  // as many will do
  EXPECT_NE(JudgeOverlap(evidence, options).reason, EvidenceReason::kNotSpread);
}

TEST(JudgeOverlap, HoldsBackAPosterInFrontOfTheCamera) {
  const EvidenceVerdict verdict = JudgeOverlap(MakeEvidence(FlatWorld()), {});
  EXPECT_EQ(verdict.verdict, MergeVerdict::kProvisional);
  EXPECT_EQ(verdict.reason, EvidenceReason::kOneDepth);
  EXPECT_LT(verdict.off_plane_share, 1e-6);
}

TEST(JudgeOverlap, TakesAnObjectInFrontOfAPlaneAsASecondDepth) {
  OverlapEvidence evidence = MakeEvidence(FlatWorld());
  for (size_t i = 0; i < evidence.inliers.size(); i += 4) evidence.inliers[i].depth *= 0.8;
  const EvidenceVerdict verdict = JudgeOverlap(evidence, {});
  EXPECT_EQ(verdict.verdict, MergeVerdict::kAccepted) << verdict.text;
  EXPECT_NEAR(verdict.off_plane_share, 0.25, 0.02);
}

TEST(JudgeOverlap, LetsAbsenceRefute) {
  OverlapEvidence evidence = CompleteEvidence();
  evidence.num_visible_matched = 9;
  const EvidenceVerdict verdict = JudgeOverlap(evidence, {});
  EXPECT_EQ(verdict.verdict, MergeVerdict::kRefused);
  EXPECT_EQ(verdict.reason, EvidenceReason::kAbsent);
  EXPECT_NE(verdict.text.find("9 of 100"), std::string::npos);
}

TEST(JudgeOverlap, HoldsBackALowOrUnknownShare) {
  OverlapEvidence evidence = CompleteEvidence();
  evidence.num_visible_matched = 19;
  EXPECT_EQ(JudgeOverlap(evidence, {}).reason, EvidenceReason::kLowShare);
  evidence.num_visible = 10;
  evidence.num_visible_matched = 0;  // of so few, none says nothing
  EXPECT_EQ(JudgeOverlap(evidence, {}).reason, EvidenceReason::kVisibilityUnknown);
  evidence.num_visible = 0;
  EXPECT_EQ(JudgeOverlap(evidence, {}).reason, EvidenceReason::kVisibilityUnknown);
}

TEST(JudgeOverlap, AcceptsFromAsideWhatIsOverwhelming) {
  OverlapEvidence evidence = CompleteEvidence();
  evidence.num_visible = 0;
  evidence.num_wide = 500;
  evidence.num_wide_matched = 250;
  EXPECT_EQ(JudgeOverlap(evidence, {}).reason, EvidenceReason::kVisibilityUnknown);  // alone
  evidence.neighbour_log_scales = {0.005, -0.004};
  const EvidenceVerdict verdict = JudgeOverlap(evidence, {});
  EXPECT_EQ(verdict.verdict, MergeVerdict::kAccepted) << verdict.text;
  EXPECT_NE(verdict.text.find("250 of 500"), std::string::npos) << verdict.text;
  evidence.num_wide_matched = 150;  // a thing that two rooms share
  EXPECT_EQ(JudgeOverlap(evidence, {}).reason, EvidenceReason::kVisibilityUnknown);
  evidence.num_wide_matched = 250;
  evidence.inliers.resize(99);
  EXPECT_EQ(JudgeOverlap(evidence, {}).reason, EvidenceReason::kVisibilityUnknown);
}

TEST(JudgeOverlap, AsksTheNeighboursForTheScale) {
  OverlapEvidence evidence = CompleteEvidence();
  evidence.neighbour_log_scales = {0.01, -0.02, 0.5};
  EXPECT_EQ(JudgeOverlap(evidence, {}).verdict, MergeVerdict::kAccepted);
  evidence.neighbour_log_scales = {0.1, -0.1};
  EXPECT_EQ(JudgeOverlap(evidence, {}).reason, EvidenceReason::kNeighboursDisagree);
  evidence.neighbour_log_scales = {0.5, -0.5};
  const EvidenceVerdict verdict = JudgeOverlap(evidence, {});
  EXPECT_EQ(verdict.verdict, MergeVerdict::kRefused);
  EXPECT_EQ(verdict.reason, EvidenceReason::kNeighboursContradict);
}

TEST(JudgeOverlap, HoldsBackAScaleThatIsHardlyKnown) {
  OverlapEvidence evidence = CompleteEvidence();
  evidence.neighbour_log_scales = {0.01, -0.02};
  evidence.sigma_log_scale = 0.029;
  EXPECT_EQ(JudgeOverlap(evidence, {}).verdict, MergeVerdict::kAccepted);
  evidence.sigma_log_scale = 0.067;
  const EvidenceVerdict verdict = JudgeOverlap(evidence, {});
  EXPECT_EQ(verdict.verdict, MergeVerdict::kProvisional);
  EXPECT_EQ(verdict.reason, EvidenceReason::kScaleUnknown);
  EXPECT_EQ(verdict.text, "the scale is known to 6.7 % only");
}

TEST(JudgeOverlap, HoldsBackAScaleThatOneFrameAloneTells) {
  OverlapEvidence evidence = CompleteEvidence();
  evidence.sigma_log_scale = 0.01;
  const EvidenceVerdict verdict = JudgeOverlap(evidence, {});
  EXPECT_EQ(verdict.verdict, MergeVerdict::kProvisional);
  EXPECT_EQ(verdict.reason, EvidenceReason::kScaleUnknown);
  EXPECT_EQ(verdict.text, "no neighbouring frame tells the scale");
  evidence.sigma_log_scale = 0.0;  // told by odometry
  EXPECT_EQ(JudgeOverlap(evidence, {}).verdict, MergeVerdict::kAccepted);
}

TEST(EvidenceOptions, NameWhatIsOutOfRange) {
  EvidenceOptions options;
  std::string error;
  EXPECT_TRUE(IsValid(options, &error));
  options.min_rows = 5;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_NE(error.find("min_rows"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
