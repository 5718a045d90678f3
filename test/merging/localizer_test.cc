#include "rovio_sfm/merging/localizer.h"

#include <gtest/gtest.h>

#include "merging/keeper_fixture.h"

namespace rovio_sfm {
namespace {

// The map holds drive a alone; drive b passes through it.
class LocalizerTest : public ::testing::Test {
 protected:
  LocalizerTest() : store_(StoreOf(two_)), keeper_({}, &store_, &executor_, ResultTiming::kFixed) {
    keeper_.LendSessions()->Adopt(MappedSession(two_, false, OtherGauge()));
  }

  Rigid3 TruePose(uint32_t frame) const {
    return TransformCamera(OtherGauge(), two_.world.cams_from_map[CameraOf(true, frame)]);
  }
  void ExpectTrue(const std::optional<Localization>& pose, uint32_t frame) const {
    ASSERT_TRUE(pose) << "frame " << frame;
    EXPECT_EQ(pose->id, two_.b[frame].id);
    EXPECT_EQ(pose->session.value, 1u);
    const Rigid3 error = pose->cam_from_session * Inverse(TruePose(frame));
    EXPECT_LT(error.translation.norm(), 1e-4);
    EXPECT_LT(RotationAngle(error.rotation), 1e-4);
  }

  const TwoDrives two_ = MakeTwoDrives();
  MemoryFrameStore store_;
  Executor executor_{0};
  MapKeeper keeper_;
  Localizer localizer_{{}, &keeper_};
};

TEST_F(LocalizerTest, APlaceMatchPosesItsFrameAndTracksThoseThatFollow) {
  const uint64_t revision = keeper_.sessions().Find({1})->revision();
  EXPECT_FALSE(localizer_.Add(two_.b[8])) << "nothing says yet what it shows";
  ExpectTrue(localizer_.Add(TrueOverlap(two_, 8, 8)), 8);
  for (uint32_t i = 9; i < two_.b.size(); ++i) ExpectTrue(localizer_.Add(two_.b[i]), i);
  EXPECT_EQ(localizer_.num_posed(), two_.b.size() - 8);
  EXPECT_EQ(keeper_.sessions().Find({1})->revision(), revision) << "the map was changed";
  EXPECT_EQ(keeper_.sessions().all().size(), 1u);
}

TEST_F(LocalizerTest, AMatchOfAFrameThatIsNotKnownPosesNothing) {
  localizer_.Add(two_.b[9]);
  EXPECT_FALSE(localizer_.Add(TrueOverlap(two_, 8, 8))) << "its frame never came";
  PlaceMatch nowhere = TrueOverlap(two_, 8, 8);
  nowhere.pairs[0].other.index = 999;
  nowhere.query.index = 9;
  EXPECT_FALSE(localizer_.Add(nowhere));
}

TEST_F(LocalizerTest, AMatchThatComesBeforeItsFrameWaitsForIt) {
  localizer_.Add(two_.b[7]);
  EXPECT_FALSE(localizer_.Add(TrueOverlap(two_, 8, 8)));
  ExpectTrue(localizer_.Add(two_.b[8]), 8);
}

TEST_F(LocalizerTest, WrongMatchesPoseNothing) {
  PlaceMatch wrong = TrueOverlap(two_, 8, 8);
  std::vector<FeatureMatch>& inliers = wrong.pairs[0].inliers;
  for (size_t i = 0; i < inliers.size(); ++i)
    inliers[i].b = inliers[(i * 7 + 3) % inliers.size()].b;
  localizer_.Add(two_.b[8]);
  EXPECT_FALSE(localizer_.Add(wrong));
}

TEST_F(LocalizerTest, AFewWrongMatchesAreForgottenWithTheirTracks) {
  PlaceMatch mixed = TrueOverlap(two_, 8, 8);
  std::vector<FeatureMatch>& inliers = mixed.pairs[0].inliers;
  for (size_t i = 0; i + 1 < inliers.size(); i += 4) std::swap(inliers[i].b, inliers[i + 1].b);
  localizer_.Add(two_.b[8]);
  ExpectTrue(localizer_.Add(mixed), 8);
  ExpectTrue(localizer_.Add(two_.b[9]), 9);
}

}  // namespace
}  // namespace rovio_sfm
