#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/io/dataset_folder.h"

namespace rovio_sfm {

// Whether an answer to a query is right, by the definitions of docs/benchmarks.md, "Places".
enum class PlaceLabel : uint8_t { kNegative = 0, kBetween = 1, kPositive = 2 };

// From overlaps: positive from 40 % of the pixels and below 25 degrees, negative below 5 %.
PlaceLabel LabelOfOverlap(double covisible_share, double angle_deg);
// From poses: positive within 0.5 m and 30 degrees between the optical axes (a camera may roll),
// negative beyond 1.5 m or 60 degrees.
PlaceLabel LabelOfPoses(const Rigid3& world_from_a, const Rigid3& world_from_b);

// Some images of a data-set folder, by their index in it.
struct PlaceImages {
  DatasetFolder dataset;
  std::vector<uint32_t> indices;             // into dataset.images
  std::vector<std::optional<Rigid3>> poses;  // world_from_camera; one per index
};

// FOLDER or FOLDER@FIRST:LAST, of which every stride-th image. Throws std::runtime_error for
// anything else.
PlaceImages ReadPlaceImages(const std::string& argument, size_t stride);

// labels[query][database image], both counted over all folders in the order given.
using PlaceTruth = std::vector<std::vector<PlaceLabel>>;

enum class TruthSource { kOverlaps, kPoses };

// Truth of queries against the database; the last num_distractors of the database are negative.
// Overlaps hold within one folder, poses between any two (an image without is never scored).
PlaceTruth FindPlaceTruth(const std::vector<PlaceImages>& queries,
                          const std::vector<PlaceImages>& database, size_t num_distractors,
                          TruthSource source);

// A sentence for where no query has a positive: the files that are missing, or that nobody sees the
// same place. self_gap: of PlaceTrialOptions; 0 where there is a database.
std::string WhyNoPositive(const std::vector<PlaceImages>& queries,
                          const std::vector<PlaceImages>& database, size_t self_gap,
                          TruthSource source);

// Truth from a text file: a row per query, a number per database image that is no distractor: 1
// positive, 0 negative, -1 between. Throws std::runtime_error naming line and field.
PlaceTruth ReadPlaceTruth(const std::filesystem::path& file, size_t num_queries,
                          size_t num_database, size_t num_distractors);

}  // namespace rovio_sfm
