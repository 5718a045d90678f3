#include <gtest/gtest.h>

#include "scene/random_session.h"

namespace rovio_sfm {
namespace {

const Eigen::Vector3d kCorrection{0.004, -0.003, 0.002};

Session SomeSession() {
  Session session({1}, {"rovio", 1, 0}, MakeSyntheticCamera());
  Rng rng(3);
  for (int i = 0; i < 200; ++i) MutateAtRandom(&session, rng);
  return session;
}

using PointsOfFrames = std::map<uint32_t, std::vector<Eigen::Vector2d>>;

PointsOfFrames PointsOf(const Session& session) {
  PointsOfFrames points;
  for (const auto& [index, frame] : session.keyframes()) points[index] = frame.points;
  return points;
}

TEST(SessionCamera, NormalisesTheSamePixelsAnew) {
  Session session = SomeSession();
  const PointsOfFrames before = PointsOf(session);
  const Camera given = session.camera(), other = CorrectedCamera(given, kCorrection);
  const uint64_t revision = session.revision();
  ASSERT_TRUE(session.SetCamera(other));
  EXPECT_TRUE(session.camera() == other);
  EXPECT_TRUE(session.given_camera() == given);
  EXPECT_GT(session.revision(), revision);
  ASSERT_GT(before.size(), 10u);
  for (const auto& [index, points] : before) {
    for (size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector2d pixel = PixelFromNormalized(other, session.keyframe(index).points[i]);
      EXPECT_LT((pixel - PixelFromNormalized(given, points[i])).norm(), 1e-4);
    }
  }
}

TEST(SessionCamera, ComesBackToTheByteByAnyWay) {
  Session session = SomeSession();
  const PointsOfFrames before = PointsOf(session);
  const Camera given = session.camera();
  ASSERT_TRUE(session.SetCamera(CorrectedCamera(given, kCorrection)));
  ASSERT_TRUE(session.SetCamera(CorrectedCamera(given, -2.0 * kCorrection)));
  ASSERT_TRUE(session.SetCamera(given));
  EXPECT_EQ(PointsOf(session), before);
}

TEST(SessionCamera, GoesBackWithAMarkAndSoDoFramesThatWentSince) {
  Session session = SomeSession();
  const PointsOfFrames before = PointsOf(session);
  const Camera given = session.camera();
  const uint32_t mark = session.Mark();
  session.RemoveKeyframe(before.begin()->first);
  ASSERT_TRUE(session.SetCamera(CorrectedCamera(given, kCorrection)));
  session.RemoveKeyframe(std::next(before.begin())->first);
  session.RestoreTo(mark);
  EXPECT_TRUE(session.camera() == given);
  EXPECT_EQ(PointsOf(session), before);
  EXPECT_EQ(CheckInvariants(session), "");
}

TEST(SessionCamera, NewFramesAreNormalisedByItToo) {
  Session early = SomeSession(), late = SomeSession();
  uint32_t index = 0;
  while (early.keyframes().count(index) + early.light_frames().count(index) != 0) ++index;
  const Camera other = CorrectedCamera(early.camera(), kCorrection);
  early.AddKeyframe(index, BareKeyframe(index));
  ASSERT_TRUE(early.SetCamera(other));
  ASSERT_TRUE(late.SetCamera(other));
  late.AddKeyframe(index, BareKeyframe(index));
  EXPECT_EQ(PointsOf(early), PointsOf(late));
}

TEST(SessionCamera, RefusesOneThatCannotBeInvertedAtAFeature) {
  Session session = SomeSession();
  const PointsOfFrames before = PointsOf(session);
  Camera folded = session.camera();
  folded.k1 = -20.0;
  EXPECT_FALSE(session.SetCamera(folded));
  EXPECT_TRUE(session.camera() == session.given_camera());
  EXPECT_EQ(PointsOf(session), before);
}

}  // namespace
}  // namespace rovio_sfm
