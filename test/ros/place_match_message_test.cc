#include "rovio_sfm/ros/place_match_message.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace rovio_sfm {
namespace {

PlaceMatch Match() {
  PlaceMatch match;
  match.query = {{"rovio2", 1600000000123456789, 7}, 44};
  match.probability = 0.75;
  match.score = 31.5;
  const Rigid3 turned{Eigen::Quaterniond(0.8, 0.0, 0.6, 0.0), Eigen::Vector3d(0.6, 0.0, -0.8)};
  const DriveId first{"rovio1", 1500000000123456789, 42};
  match.pairs.push_back({{first, 17}, PairVerdict::kGeneral, turned, {{1, 2}, {3, 4}, {9, 0}}});
  match.pairs.push_back(
      {{first, 18}, PairVerdict::kRotation, {turned.rotation, {0, 0, 0}}, {{5, 6}}});
  return match;
}

TEST(PlaceMatchMessage, RoundTripKeepsTheMatch) {
  const PlaceMatch match = Match();
  std::string error;
  const auto back = FromMessage(ToMessage(match, 1600000001000000000), &error);
  ASSERT_TRUE(back) << error;
  EXPECT_EQ(back->query, match.query);
  EXPECT_EQ(back->probability, match.probability);
  EXPECT_EQ(back->score, match.score);
  ASSERT_EQ(back->pairs.size(), match.pairs.size());
  for (size_t i = 0; i < match.pairs.size(); ++i) {
    EXPECT_EQ(back->pairs[i].other, match.pairs[i].other);
    EXPECT_EQ(back->pairs[i].verdict, match.pairs[i].verdict);
    EXPECT_LT(
        (back->pairs[i].query_from_other.translation - match.pairs[i].query_from_other.translation)
            .norm(),
        1e-12);
    ASSERT_EQ(back->pairs[i].inliers.size(), match.pairs[i].inliers.size());
    for (size_t j = 0; j < match.pairs[i].inliers.size(); ++j) {
      EXPECT_EQ(back->pairs[i].inliers[j].a, match.pairs[i].inliers[j].a);
      EXPECT_EQ(back->pairs[i].inliers[j].b, match.pairs[i].inliers[j].b);
    }
  }
}

TEST(PlaceMatchMessage, CarriesTheStampOfTheImage) {
  EXPECT_EQ(ToMessage(Match(), 5'000'000'007).header.stamp, ros::Time(5, 7));
}

struct Refusal {
  std::string name;   // of the test
  std::string field;  // that the error must name
  std::function<void(PlaceMatchMsg*)> spoil;
};

class PlaceMatchRefusal : public testing::TestWithParam<Refusal> {};

TEST_P(PlaceMatchRefusal, NamesTheField) {
  PlaceMatchMsg message = ToMessage(Match(), 0);
  GetParam().spoil(&message);
  std::string error;
  EXPECT_FALSE(FromMessage(message, &error));
  EXPECT_NE(error.find(GetParam().field), std::string::npos) << error;
}

INSTANTIATE_TEST_SUITE_P(
    Rules, PlaceMatchRefusal,
    testing::Values(
        Refusal{"OddRobotName", "robot", [](auto* m) { m->query.drive.robot = "../etc"; }},
        Refusal{"OddOtherRobot", "robot", [](auto* m) { m->pairs[1].other.drive.robot = ""; }},
        Refusal{"ProbabilityAboveOne", "probability", [](auto* m) { m->probability = 1.5; }},
        Refusal{"NanProbability", "probability", [](auto* m) { m->probability = NAN; }},
        Refusal{"InfiniteScore", "score", [](auto* m) { m->score = INFINITY; }},
        Refusal{"NoPairs", "pairs", [](auto* m) { m->pairs.clear(); }},
        Refusal{"FloodOfPairs", "pairs", [](auto* m) { m->pairs.resize(1001); }},
        Refusal{"FailedPair", "verdict", [](auto* m) { m->pairs[0].verdict = 0; }},
        Refusal{"UnknownVerdict", "verdict", [](auto* m) { m->pairs[0].verdict = 9; }},
        Refusal{"NanPose", "query_from_other",
                [](auto* m) { m->pairs[0].query_from_other.translation.x = NAN; }},
        Refusal{"LongTranslation", "query_from_other",
                [](auto* m) { m->pairs[0].query_from_other.translation.x = 5.0; }},
        Refusal{"GeneralWithoutTranslation", "query_from_other",
                [](auto* m) { m->pairs[1].verdict = OverlapPairMsg::GENERAL; }},
        Refusal{"NoQuaternion", "query_from_other",
                [](auto* m) { m->pairs[0].query_from_other.rotation.w = 0.0; }},
        Refusal{"ShortInliers", "inlier_other",
                [](auto* m) { m->pairs[0].inlier_query.pop_back(); }},
        Refusal{"NoInliers", "inlier_other",
                [](auto* m) {
                  m->pairs[0].inlier_query.clear();
                  m->pairs[0].inlier_other.clear();
                }},
        Refusal{"FeatureTwice", "inlier_query", [](auto* m) { m->pairs[0].inlier_query[1] = 2; }},
        Refusal{"ItselfAsOther", "pairs.other", [](auto* m) { m->pairs[0].other = m->query; }}),
    [](const auto& refusal) { return refusal.param.name; });

}  // namespace
}  // namespace rovio_sfm
