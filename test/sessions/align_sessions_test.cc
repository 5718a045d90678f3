#include "rovio_sfm/sessions/align_sessions.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/check_options.h"
#include "sessions/cross_matches.h"

namespace rovio_sfm {
namespace {

const Eigen::Vector3d kMiddle(0.5, 0.0, 4.0);  // of the world, in session a

double ErrorOf(const AlignReport& report, const TwoSessions& sessions) {
  return SimilarityDistance(report.alignment->b_from_a, sessions.b_from_a, kMiddle);
}

TwoSessions NoisySessions(uint64_t seed) {
  TwoSessionsOptions options;
  options.world.seed = seed;
  options.world.noise_px = 1.0;
  options.sigma_log_distance = 0.03;
  return MakeTwoSessions(options);
}

std::vector<CrossMatch> WithoutLandmarksOfB(std::vector<CrossMatch> matches, size_t kept) {
  for (size_t i = kept; i < matches.size(); ++i) matches[i].b.landmark.reset();
  return matches;
}

TEST(AlignByPoints, IsExactWithoutNoise) {
  const TwoSessions sessions = MakeTwoSessions({});
  const auto matches = MakeCrossMatches(sessions, 1, 2);
  Rng rng(1);
  const AlignReport report = AlignByPoints(matches, {}, rng);
  ASSERT_TRUE(report.alignment) << ToString(report.refusal);
  EXPECT_LT(ErrorOf(report, sessions), 1e-6);
  EXPECT_EQ(report.alignment->inliers.size(), matches.size());
  EXPECT_EQ(report.num_common, static_cast<int>(matches.size()));
  EXPECT_EQ(report.alignment->num_common, report.num_common);
  EXPECT_LT(report.alignment->rms_sigmas, 1e-5);
  EXPECT_FALSE(report.alignment->by_resection);
}

TEST(AlignByPoints, StaysNearWithNoiseAndOutliers) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const TwoSessions sessions = NoisySessions(seed);
    const auto matches = MakeCrossMatches(sessions, 1, 2, 0.4);
    Rng rng(seed);
    const AlignReport report = AlignByPoints(matches, {}, rng);
    ASSERT_TRUE(report.alignment) << ToString(report.refusal);
    EXPECT_LT(ErrorOf(report, sessions), 0.06);
    EXPECT_LT(std::abs(std::log(report.alignment->b_from_a.scale / sessions.b_from_a.scale)),
              3.0 * report.alignment->sigma_log_scale);
    EXPECT_LT(report.alignment->sigma_log_scale, 0.03);
    int num_true = 0;
    for (const uint32_t i : report.alignment->inliers) {
      num_true += matches[i].a.track == matches[i].b.track ? 1 : 0;
    }
    EXPECT_GE(num_true, 0.97 * static_cast<double>(report.alignment->inliers.size()));
    EXPECT_GE(num_true, 0.5 * static_cast<double>(matches.size()));
  }
}

TEST(AlignByPoints, GivesTheSameBytesTwice) {
  const TwoSessions sessions = NoisySessions(3);
  const auto matches = MakeCrossMatches(sessions, 1, 2, 0.3);
  Rng rng_1(7), rng_2(7);
  const auto one = AlignByPoints(matches, {}, rng_1), two = AlignByPoints(matches, {}, rng_2);
  ASSERT_TRUE(one.alignment && two.alignment);
  EXPECT_EQ(one.alignment->b_from_a.scale, two.alignment->b_from_a.scale);
  EXPECT_EQ(one.alignment->b_from_a.translation, two.alignment->b_from_a.translation);
  EXPECT_EQ(one.alignment->inliers, two.alignment->inliers);
}

TEST(AlignByPoints, DoesNotDependOnTheGauge) {
  TwoSessionsOptions options;
  options.world.noise_px = 1.0;
  const TwoSessions near = MakeTwoSessions(options);
  options.b_from_a = {250.0, Eigen::Quaterniond(0.1, 0.9, 0.3, -0.2).normalized(), {900, 40, -7}};
  const TwoSessions far = MakeTwoSessions(options);
  Rng rng_1(7), rng_2(7);
  const auto one = AlignByPoints(MakeCrossMatches(near, 1, 2, 0.2), {}, rng_1);
  const auto two = AlignByPoints(MakeCrossMatches(far, 1, 2, 0.2), {}, rng_2);
  ASSERT_TRUE(one.alignment && two.alignment);
  EXPECT_NEAR(ErrorOf(one, near), ErrorOf(two, far), 1e-5);
  EXPECT_EQ(one.alignment->inliers, two.alignment->inliers);
  EXPECT_NEAR(one.alignment->sigma_log_scale, two.alignment->sigma_log_scale, 1e-6);
}

TEST(AlignByPoints, RefusesTooFewMatches) {
  const TwoSessions sessions = MakeTwoSessions({});
  auto matches = MakeCrossMatches(sessions, 1, 2);
  Rng rng(1);
  EXPECT_EQ(AlignByPoints({}, {}, rng).refusal, AlignRefusal::kTooFewMatches);
  const AlignReport few_common = AlignByPoints(WithoutLandmarksOfB(matches, 4), {}, rng);
  EXPECT_EQ(few_common.refusal, AlignRefusal::kTooFewMatches);
  EXPECT_EQ(few_common.num_common, 4);
  matches.resize(11);
  EXPECT_EQ(AlignByPoints(matches, {}, rng).refusal, AlignRefusal::kTooFewMatches);
}

TEST(AlignByPoints, RefusesMatchesOfDifferentPlaces) {
  const TwoSessions sessions = MakeTwoSessions({});
  auto matches = MakeCrossMatches(sessions, 1, 2);
  for (size_t i = 0; i + 1 < matches.size(); ++i) std::swap(matches[i].b, matches[i + 1].b);
  Rng rng(1);
  const AlignReport report = AlignByPoints(matches, {}, rng);
  EXPECT_FALSE(report.alignment);
  EXPECT_NE(report.refusal, AlignRefusal::kNone);
}

TEST(AlignByPoints, RefusesLandmarksOnALine) {
  const TwoSessions sessions = MakeTwoSessions({});
  auto matches = MakeCrossMatches(sessions, 1, 2);
  for (size_t i = 0; i < matches.size(); ++i) {
    const Eigen::Vector3d x_in_a(0.3 + 0.01 * static_cast<double>(i), 0.2, 4.0);
    matches[i].a.landmark->position = x_in_a;
    matches[i].b.landmark->position = sessions.b_from_a * x_in_a;
    matches[i].a.x_normalized = (matches[i].a.cam_from_session * x_in_a).hnormalized();
    matches[i].b.x_normalized =
        (matches[i].b.cam_from_session * matches[i].b.landmark->position).hnormalized();
  }
  Rng rng(1);
  EXPECT_FALSE(AlignByPoints(matches, {}, rng).alignment);
  EXPECT_EQ(RefineAlignment(matches, sessions.b_from_a, {}).refusal, AlignRefusal::kUndetermined);
}

TEST(AlignFromPose, IsExactWithFewCommonLandmarks) {
  const TwoSessions sessions = MakeTwoSessions({});
  const auto matches = WithoutLandmarksOfB(MakeCrossMatches(sessions, 1, 2), 6);
  const Rigid3 cam_from_a = sessions.a.keyframe(1).cam_from_session;
  const AlignReport report =
      AlignFromPose(matches, cam_from_a, TransformCamera(sessions.b_from_a, cam_from_a), {});
  ASSERT_TRUE(report.alignment) << ToString(report.refusal);
  EXPECT_LT(ErrorOf(report, sessions), 1e-6);
  EXPECT_TRUE(report.alignment->by_resection);
  EXPECT_EQ(report.alignment->num_common, 6);
}

TEST(AlignFromPose, BearsNoiseFalseMatchesAndARoughPose) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const TwoSessions sessions = NoisySessions(seed);
    const Rigid3 cam_from_a = sessions.a.keyframe(1).cam_from_session;
    Rng rng(seed);
    const Rigid3 cam_from_b =
        PerturbPose(TransformCamera(sessions.b_from_a, cam_from_a), 0.002, 0.01, rng);
    const AlignReport report =
        AlignFromPose(MakeCrossMatches(sessions, 1, 2, 0.3), cam_from_a, cam_from_b, {});
    ASSERT_TRUE(report.alignment) << ToString(report.refusal);
    EXPECT_LT(ErrorOf(report, sessions), 0.06);
  }
}

TEST(AlignFromPose, RefusesWithoutCommonLandmarks) {
  const TwoSessions sessions = MakeTwoSessions({});
  const auto matches = WithoutLandmarksOfB(MakeCrossMatches(sessions, 1, 2), 0);
  const Rigid3 cam_from_a = sessions.a.keyframe(1).cam_from_session;
  const Rigid3 cam_from_b = TransformCamera(sessions.b_from_a, cam_from_a);
  EXPECT_EQ(AlignFromPose(matches, cam_from_a, cam_from_b, {}).refusal,
            AlignRefusal::kTooFewMatches);
  EXPECT_EQ(AlignFromPose({}, cam_from_a, cam_from_b, {}).refusal, AlignRefusal::kTooFewMatches);
}

TEST(RefineAlignment, RefusesAnUnknownScale) {
  const TwoSessions sessions = MakeTwoSessions({});
  auto matches = MakeCrossMatches(sessions, 1, 2);
  AlignOptions options;
  for (CrossMatch& match : matches) match.a.landmark->sigma_log_distance = 3.0;
  for (CrossMatch& match : matches) match.b.landmark->sigma_log_distance = 3.0;
  EXPECT_EQ(RefineAlignment(matches, sessions.b_from_a, options).refusal,
            AlignRefusal::kScaleUncertain);
  EXPECT_EQ(RefineAlignment(WithoutLandmarksOfB(matches, 0), sessions.b_from_a, options).refusal,
            AlignRefusal::kTooFewCommon);
}

TEST(RefineAlignment, DrawsAPoorStartToTheTruth) {
  const TwoSessions sessions = MakeTwoSessions({});
  Sim3 initial = sessions.b_from_a;
  initial.scale *= 1.02;
  const AlignReport report = RefineAlignment(MakeCrossMatches(sessions, 1, 2), initial, {});
  ASSERT_TRUE(report.alignment) << ToString(report.refusal);
  EXPECT_LT(ErrorOf(report, sessions), 1e-6);
}

TEST(RefineAlignment, TakesTheScaleFromAPrior) {
  const TwoSessions sessions = MakeTwoSessions({});
  const auto matches = WithoutLandmarksOfB(MakeCrossMatches(sessions, 1, 2), 0);
  const Rigid3 cam_from_b = sessions.b.keyframe(2).cam_from_session;
  const Rigid3 cam_from_a = TransformCamera(Inverse(sessions.b_from_a), cam_from_b);
  const ScalePrior prior{sessions.b_from_a.scale, 0.03};
  Sim3 initial = SimilarityFromCamera(cam_from_a, cam_from_b, prior.scale);
  initial.translation.x() += 0.01;
  const AlignReport report = RefineAlignment(matches, initial, {}, prior);
  ASSERT_TRUE(report.alignment) << ToString(report.refusal);
  EXPECT_LT(ErrorOf(report, sessions), 1e-5);
  EXPECT_NEAR(report.alignment->sigma_log_scale, 0.03, 0.002);
}

TEST(SimilarityFromCamera, GivesOneCameraBothPoses) {
  const TwoSessions sessions = MakeTwoSessions({});
  const Rigid3 cam_from_a = sessions.a.keyframe(1).cam_from_session;
  const Rigid3 cam_from_b = TransformCamera(sessions.b_from_a, cam_from_a);
  const Sim3 b_from_a = SimilarityFromCamera(cam_from_a, cam_from_b, sessions.b_from_a.scale);
  EXPECT_LT(SimilarityDistance(b_from_a, sessions.b_from_a, kMiddle), 1e-6);
}

TEST(AlignOptions, NameWhatIsOutOfRange) {
  AlignOptions options;
  std::string error;
  EXPECT_TRUE(IsValid(options, &error));
  options.min_common = 2;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_NE(error.find("min_common"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
