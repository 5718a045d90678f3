#include "rovio_sfm/tools/place_curve.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

constexpr PlaceLabel kNo = PlaceLabel::kNegative;
constexpr PlaceLabel kMaybe = PlaceLabel::kBetween;
constexpr PlaceLabel kYes = PlaceLabel::kPositive;

std::optional<PlaceAnswer> Answer(size_t other, double score) { return PlaceAnswer{other, score}; }

TEST(MeasurePlaceCurve, CountsRightWrongAndMissing) {
  const PlaceTruth truth{{kYes, kNo}, {kYes, kNo}, {kYes, kNo}, {kNo, kNo}};
  const PlaceCurve curve =
      MeasurePlaceCurve({Answer(0, 3.0), Answer(1, 2.0), std::nullopt, std::nullopt}, truth);
  EXPECT_EQ(curve.num_queries, 4u);
  EXPECT_EQ(curve.num_positive, 3u);
  EXPECT_EQ(curve.num_right, 1u);
  EXPECT_EQ(curve.num_wrong, 1u);
  EXPECT_DOUBLE_EQ(curve.precision, 0.5);
  EXPECT_DOUBLE_EQ(curve.recall, 1.0 / 3.0);
}

TEST(MeasurePlaceCurve, AnswersBetweenAreNeitherRightNorWrongNorMissing) {
  const PlaceTruth truth{{kYes, kMaybe}, {kYes, kMaybe}, {kYes, kMaybe}};
  const PlaceCurve curve = MeasurePlaceCurve({Answer(1, 3.0), Answer(0, 2.0), std::nullopt}, truth);
  EXPECT_EQ(curve.num_between, 1u);
  EXPECT_EQ(curve.num_positive, 3u);
  EXPECT_DOUBLE_EQ(curve.precision, 1.0);
  EXPECT_DOUBLE_EQ(curve.recall, 0.5);
  EXPECT_DOUBLE_EQ(curve.strict_recall, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(curve.strict_area, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(curve.recall_at_full_precision, 0.5);
  EXPECT_DOUBLE_EQ(curve.strict_recall_at_full_precision, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(curve.strict_recall_at_95_precision, 1.0 / 3.0);
}

TEST(MeasurePlaceCurve, AreaOfARightThenAWrongThenARightAnswer) {
  const PlaceTruth truth{{kYes, kNo}, {kYes, kNo}, {kYes, kNo}};
  const PlaceCurve curve =
      MeasurePlaceCurve({Answer(0, 3.0), Answer(1, 2.0), Answer(0, 1.0)}, truth);
  ASSERT_EQ(curve.points.size(), 3u);
  EXPECT_NEAR(curve.area, 1.0 / 3.0 + 2.0 / 3.0 / 3.0, 1e-12);
  EXPECT_NEAR(curve.recall_at_full_precision, 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(curve.recall_at_95_precision, 1.0 / 3.0, 1e-12);
}

TEST(MeasurePlaceCurve, EqualScoresCountTogether) {
  const PlaceTruth truth{{kYes, kNo}, {kYes, kNo}};
  const PlaceCurve curve = MeasurePlaceCurve({Answer(0, 1.0), Answer(1, 1.0)}, truth);
  ASSERT_EQ(curve.points.size(), 1u);
  EXPECT_DOUBLE_EQ(curve.recall_at_full_precision, 0.0);
}

TEST(MeasurePlaceCurve, RecallAt95PrecisionMayComeAfterAWrongAnswer) {
  PlaceTruth truth(40, {kYes, kNo});
  std::vector<std::optional<PlaceAnswer>> answers(40, Answer(0, 1.0));
  answers[0] = Answer(1, 5.0);
  const PlaceCurve curve = MeasurePlaceCurve(answers, truth);
  EXPECT_DOUBLE_EQ(curve.recall_at_full_precision, 0.0);
  EXPECT_DOUBLE_EQ(curve.recall_at_95_precision, 39.0 / 40.0);
}

TEST(MeasurePlaceCurve, NoQueriesGiveNoRecall) {
  const PlaceCurve curve = MeasurePlaceCurve({}, {});
  EXPECT_DOUBLE_EQ(curve.recall, 0.0);
  EXPECT_TRUE(curve.points.empty());
}

}  // namespace
}  // namespace rovio_sfm
