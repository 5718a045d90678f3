#include "rovio_sfm/tools/place_curve.h"

#include <algorithm>

namespace rovio_sfm {
namespace {

struct LabeledAnswer {
  double score = 0.0;
  PlaceLabel label = PlaceLabel::kNegative;
  bool has_positive = false;  // the query has a right answer
};

double Share(size_t part, size_t whole, double of_nothing) {
  return whole == 0 ? of_nothing : static_cast<double>(part) / static_cast<double>(whole);
}

void Count(const LabeledAnswer& answer, size_t* num_not_scored, PlaceCurve* curve) {
  if (answer.label == PlaceLabel::kPositive) ++curve->num_right;
  if (answer.label == PlaceLabel::kNegative) ++curve->num_wrong;
  if (answer.label == PlaceLabel::kBetween) ++curve->num_between;
  if (answer.label == PlaceLabel::kBetween && answer.has_positive) ++*num_not_scored;
  curve->precision = Share(curve->num_right, curve->num_right + curve->num_wrong, 1.0);
  curve->recall = Share(curve->num_right, curve->num_positive - *num_not_scored, 0.0);
  curve->strict_recall = Share(curve->num_right, curve->num_positive, 0.0);
}

void AddPoint(double threshold, PlaceCurve* curve) {
  const PlaceOperatingPoint last =
      curve->points.empty() ? PlaceOperatingPoint{} : curve->points.back();
  curve->points.push_back({threshold, curve->precision, curve->recall, curve->strict_recall});
  curve->area += curve->precision * (curve->recall - last.recall);
  curve->strict_area += curve->precision * (curve->strict_recall - last.strict_recall);
  if (curve->num_wrong == 0) {
    curve->recall_at_full_precision = curve->recall;
    curve->strict_recall_at_full_precision = curve->strict_recall;
  }
  if (curve->precision >= 0.95) {
    curve->recall_at_95_precision = curve->recall;
    curve->strict_recall_at_95_precision = curve->strict_recall;
  }
}

}  // namespace

PlaceCurve MeasurePlaceCurve(const std::vector<std::optional<PlaceAnswer>>& answers,
                             const PlaceTruth& truth) {
  PlaceCurve curve;
  curve.num_queries = answers.size();
  std::vector<LabeledAnswer> labeled;
  for (size_t i = 0; i < answers.size(); ++i) {
    const auto& row = truth[i];
    const bool has_positive = std::count(row.begin(), row.end(), PlaceLabel::kPositive) > 0;
    if (has_positive) ++curve.num_positive;
    if (!answers[i]) continue;
    labeled.push_back({answers[i]->score, row[answers[i]->other], has_positive});
  }
  std::stable_sort(labeled.begin(), labeled.end(),
                   [](const auto& a, const auto& b) { return a.score > b.score; });
  size_t num_not_scored = 0;  // of the queries with a positive
  for (size_t i = 0; i < labeled.size(); ++i) {
    Count(labeled[i], &num_not_scored, &curve);
    const bool is_last_of_equals =
        i + 1 == labeled.size() || labeled[i + 1].score < labeled[i].score;
    if (is_last_of_equals) AddPoint(labeled[i].score, &curve);
  }
  return curve;
}

}  // namespace rovio_sfm
