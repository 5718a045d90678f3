// Evidence made to mislead (issue 3, acceptance): no wrong merge may be accepted.
#include <gtest/gtest.h>

#include <set>

#include "app/explored_land.h"
#include "rovio_sfm/geometry/essential.h"
#include "rovio_sfm/merging/map_keeper.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kThingPoints = 60;

// Explored lands (one or two) under a keeper.
struct Merging {
  explicit Merging(std::vector<Explored> explored_lands) : explored(std::move(explored_lands)) {
    for (Explored& each : explored) {
      keeper.LendSessions()->Adopt(each.session);
      for (const FrameEvent& event : each.events) store.Put(event.id, event.features);
    }
  }

  Merging(const Merging&) = delete;  // the keeper points into it
  Merging& operator=(const Merging&) = delete;

  void Add(const PlaceMatch& match) { keeper.Add(match); }
  bool InOneMap() const {
    return keeper.PlaceOf(explored[0].session.id()).map ==
           keeper.PlaceOf(explored[1].session.id()).map;
  }
  std::string Bytes() const {
    std::string bytes;
    for (const auto& [id, session] : keeper.sessions().all()) bytes += BytesOf(*session);
    return bytes;
  }
  // The verdicts so far, and what was said of an accepted one.
  std::set<MergeVerdict> Verdicts() const {
    std::set<MergeVerdict> verdicts;
    for (const MergeReport& report : keeper.Reports()) verdicts.insert(report.verdict);
    return verdicts;
  }
  std::string WhyAccepted() const {
    for (const MergeReport& report : keeper.Reports()) {
      if (report.verdict == MergeVerdict::kAccepted) return report.reason;
    }
    return "";
  }

  std::vector<Explored> explored;
  MemoryFrameStore store;
  Executor executor{0};
  MapKeeper keeper{MapOptions(), &store, &executor, ResultTiming::kFixed};
};

// The thing of so many looks, somewhere; the first look tells things apart.
void Put(uint32_t thing, const Sim3& world_from_thing, Land* land) {
  AddThing(1000 * thing, kThingPoints, {0.5, 0.5, 0.4}, world_from_thing, land);
}

// Matches of one thing alone, as epipolar geometry leaves them.
PlaceMatch MatchThing(const Merging& merging, uint32_t thing, uint32_t frame_a, uint32_t frame_b) {
  return MatchLooks(merging.explored[0], frame_a, merging.explored[1], frame_b, 1000 * thing,
                    1000 * thing + kThingPoints);
}

Merging TwoWorldsWithThreeThings() {
  Land a, b;
  AddClutter(1, 400, &a);
  AddClutter(2, 400, &b);
  Put(1, PutAt(0.6, 0.0, 2.2), &a);
  Put(2, PutAt(1.4, 0.1, 2.6, 0.4), &a);
  Put(3, PutAt(2.1, -0.1, 2.3, -0.3), &a);
  Put(1, PutAt(2.0, 0.1, 2.5, 0.2), &b);
  Put(2, PutAt(0.5, 0.0, 2.1, -0.2), &b);
  Put(3, PutAt(1.2, -0.1, 3.0, 0.5), &b);
  return Merging({Explore(1, a, {}), Explore(2, b, OtherGauge())});
}

TEST(AdversarialMerge, TwoWorldsThatShareThreeThingsStayApart) {
  Merging merging = TwoWorldsWithThreeThings();
  const std::string before = merging.Bytes();
  for (uint32_t frame_b = 0; frame_b < 20; frame_b += 6) {
    for (uint32_t frame_a = 0; frame_a < 18; frame_a += 8) {
      for (const uint32_t thing : {1u, 2u, 3u}) {
        merging.Add(MatchThing(merging, thing, frame_a + thing - 1, frame_b));
      }
    }
  }
  EXPECT_EQ(merging.keeper.num_repeated(), 0u);
  EXPECT_FALSE(merging.InOneMap()) << merging.WhyAccepted();
  EXPECT_EQ(merging.Bytes(), before);
}

TEST(AdversarialMerge, AllThreeThingsAtOnceStayApartToo) {
  Merging merging = TwoWorldsWithThreeThings();
  for (uint32_t frame = 0; frame < 20; frame += 4) {
    merging.Add(MatchLooks(merging.explored[0], frame, merging.explored[1], 19 - frame));
    merging.Add(MatchLooks(merging.explored[0], frame, merging.explored[1], frame));
  }
  EXPECT_FALSE(merging.InOneMap()) << merging.WhyAccepted();
}

// Pairs of features of two frames that lie on each other's epipolar lines of this geometry.
std::vector<FeatureMatch> MatchesOnEpipolarLines(const FrameFeatures& a, const FrameFeatures& b,
                                                 const Rigid3& b_from_a) {
  const Eigen::Matrix3d essential = EssentialFromPose(b_from_a);
  std::vector<FeatureMatch> matches;
  std::set<uint32_t> taken;
  for (uint32_t f = 0; f < b.keypoints.size(); ++f) {
    for (uint32_t g = 0; g < a.keypoints.size(); ++g) {
      const Eigen::Vector3d line = essential * a.keypoints[g].x_normalized.homogeneous();
      const double distance =
          std::abs(b.keypoints[f].x_normalized.homogeneous().dot(line)) / line.head<2>().norm();
      if (distance > 2.0 / 620.0 || !taken.insert(g).second) continue;
      matches.push_back({g, f, 100.0f, 0.5f});
      break;
    }
  }
  return matches;
}

TEST(AdversarialMerge, MatchesOfARandomEssentialMatrixJoinNothing) {
  Land a, b;
  AddClutter(1, 400, &a);
  AddClutter(2, 400, &b);
  Merging merging({Explore(1, a, {}), Explore(2, b, OtherGauge())});
  Rng rng(11);
  for (uint32_t frame = 0; frame < 20; frame += 3) {
    const Rigid3 geometry{
        Eigen::Quaterniond(Eigen::AngleAxisd(
            rng.Uniform(-0.3, 0.3),
            Eigen::Vector3d(rng.Gaussian(), rng.Gaussian(), rng.Gaussian()).normalized())),
        Eigen::Vector3d(rng.Gaussian(), rng.Gaussian(), rng.Gaussian()).normalized()};
    PlaceMatch match = MatchLooks(merging.explored[0], frame, merging.explored[1], frame);
    match.pairs[0].inliers =
        MatchesOnEpipolarLines(*merging.explored[0].events[frame].features,
                               *merging.explored[1].events[frame].features, geometry);
    ASSERT_GT(match.pairs[0].inliers.size(), 60u);
    merging.Add(match);
  }
  EXPECT_FALSE(merging.InOneMap()) << merging.WhyAccepted();
}

// Two halves of one room; in each stands the same bench, with all else different.
TEST(AdversarialMerge, TheTrueSimilarityOfTheWrongRepeatJoinsNothing) {
  Land a, b;
  AddClutter(1, 400, &a);
  AddClutter(2, 400, &b);
  const Eigen::Vector3d bench(1.6, 0.7, 0.8);
  AddThing(5000, 90, bench, PutAt(1.2, 0.1, 2.6), &a);
  AddThing(5000, 90, bench, PutAt(1.2, 0.1, 2.6), &b);
  Merging merging({Explore(1, a, {}), Explore(2, b, OtherGauge())});
  const std::string before = merging.Bytes();
  for (uint32_t frame = 2; frame < 18; frame += 3) {
    merging.Add(MatchLooks(merging.explored[0], frame, merging.explored[1], frame));
  }
  EXPECT_FALSE(merging.InOneMap()) << merging.WhyAccepted();
  EXPECT_EQ(merging.Bytes(), before);
}

TEST(AdversarialMerge, ThePanelTwiceInOneDriveClosesNoLoop) {
  Land land;
  AddClutter(1, 900, &land, 5.4);
  const Eigen::Vector3d panel(1.2, 0.8, 0.01);
  AddThing(7000, 80, panel, PutAt(0.4, 0.0, 2.4), &land);
  AddThing(7000, 80, panel, PutAt(4.4, 0.0, 2.4), &land);
  Merging merging({Explore(1, land, {}, 45)});
  const std::string before = merging.Bytes();
  for (uint32_t frame = 30; frame < 42; frame += 3) {
    merging.Add(
        MatchLooks(merging.explored[0], frame - 30, merging.explored[0], frame, 7000, 7080));
  }
  EXPECT_EQ(merging.Verdicts().count(MergeVerdict::kAccepted), 0u) << merging.WhyAccepted();
  EXPECT_EQ(merging.Bytes(), before);
}

// Two bare walls with the same poster: all that can be seen of one is seen in the other.
TEST(AdversarialMerge, OnePosterAloneStaysProvisional) {
  Land a, b;
  const Eigen::Vector3d poster(2.4, 1.4, 0.0);
  AddThing(9000, 150, poster, PutAt(1.2, 0.0, 2.0), &a);
  AddThing(9000, 150, poster, PutAt(1.3, 0.05, 2.1, 0.1), &b);
  Merging merging({Explore(1, a, {}), Explore(2, b, OtherGauge())});
  const std::string before = merging.Bytes();
  for (uint32_t frame = 0; frame < 20; frame += 4) {
    merging.Add(MatchLooks(merging.explored[0], frame, merging.explored[1], frame));
  }
  EXPECT_FALSE(merging.InOneMap()) << merging.WhyAccepted();
  EXPECT_EQ(merging.Verdicts(), std::set<MergeVerdict>{MergeVerdict::kProvisional});
  EXPECT_EQ(merging.Bytes(), before);
}

// Drives round a thing, 32 degrees and more apart, so that no landmark should be visible; from the
// second one every `strange`-th point looks different.
std::vector<Explored> RoundOneThing(uint32_t strange, bool is_in_another_room) {
  Land a;
  AddThing(5000, 400, {1.8, 1.4, 1.4}, PutAt(0.0, 0.0, 0.0), &a);
  Land b = a;
  for (uint32_t i = 0; i < b.looks.size(); i += strange) b.looks[i] += 500'000;
  if (is_in_another_room) {
    AddThing(20'000, 3000, {5.0, 2.5, 5.0}, PutAt(0.0, 0.0, 0.0), &a);
    AddThing(40'000, 3000, {5.0, 2.5, 5.0}, PutAt(0.0, 0.0, 0.0), &b);
  }
  std::vector<double> angles_a, angles_b;
  for (int i = 0; i < 12; ++i) angles_a.push_back(5.0 * i);
  for (int i = 0; i < 11; ++i) angles_b.push_back(87.0 + 5.0 * i);
  return {ExploreFrom(1, a, {}, RoundTheOrigin(2.6, angles_a)),
          ExploreFrom(2, b, OtherGauge(), RoundTheOrigin(2.6, angles_b))};
}

void AddOverlapsFromAside(Merging* merging) {
  for (uint32_t i = 0; i < 4; ++i) {
    merging->Add(MatchLooks(merging->explored[0], 11 - i, merging->explored[1], i));
  }
}

TEST(AdversarialMerge, OverwhelmingOverlapsFromAsideJoinTwoDrivesRoundAThing) {
  Merging merging(RoundOneThing(2, false));
  AddOverlapsFromAside(&merging);
  EXPECT_TRUE(merging.InOneMap()) << merging.keeper.Reports()[0].reason;
  EXPECT_EQ(merging.keeper.Reports()[0].num_expected, 0u);
}

TEST(AdversarialMerge, TheSameThingInAnotherRoomSeenFromAsideJoinsNothing) {
  Merging merging(RoundOneThing(4000, true));
  AddOverlapsFromAside(&merging);
  EXPECT_FALSE(merging.InOneMap()) << merging.WhyAccepted();
}

// The other side of the coin: what is really the same place is joined.
TEST(AdversarialMerge, TheSamePlaceIsJoinedAtOnce) {
  Land land;
  AddClutter(1, 400, &land);
  Put(1, PutAt(0.6, 0.0, 2.2), &land);
  Merging merging({Explore(1, land, {}), Explore(2, land, OtherGauge())});
  merging.Add(MatchLooks(merging.explored[0], 9, merging.explored[1], 10));
  EXPECT_TRUE(merging.InOneMap()) << merging.keeper.Reports()[0].reason;
}

}  // namespace
}  // namespace rovio_sfm
