#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "rovio_sfm/tools/place_truth.h"

namespace rovio_sfm {

// The best match of a query, if there was one.
struct PlaceAnswer {
  size_t other = 0;    // database image
  double score = 0.0;  // higher is surer
};

// Precision and recall when answers of at least that score count.
struct PlaceOperatingPoint {
  double threshold = 0.0;
  double precision = 1.0, recall = 0.0, strict_recall = 0.0;
};

struct PlaceCurve {
  size_t num_queries = 0;
  size_t num_positive = 0;  // queries with a positive in the database
  // With every answer counted:
  size_t num_right = 0, num_wrong = 0;
  size_t num_between = 0;  // answers that are not scored: neither right, nor wrong, nor missing
  double precision = 1.0, recall = 0.0;
  double area = 0.0;  // under precision over recall, by steps
  // The same where an answer that is not scored counts as missing.
  double strict_recall = 0.0, strict_area = 0.0;
  double recall_at_full_precision = 0.0, recall_at_95_precision = 0.0;
  double strict_recall_at_full_precision = 0.0, strict_recall_at_95_precision = 0.0;
  std::vector<PlaceOperatingPoint> points;  // by falling threshold
};

// One answer (or none) per query, against its row of the truth. Precision = right / (right +
// wrong); recall = right / queries with a positive, without those whose answer is not scored.
PlaceCurve MeasurePlaceCurve(const std::vector<std::optional<PlaceAnswer>>& answers,
                             const PlaceTruth& truth);

}  // namespace rovio_sfm
