#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/frontend/frontend_options.h"
#include "rovio_sfm/recognition/place_recognizer.h"
#include "rovio_sfm/tools/place_curve.h"
#include "rovio_sfm/tools/place_truth.h"

namespace rovio_sfm {

// An image ready to be asked for or remembered.
struct PlaceImage {
  std::string name;  // folder/file, for people
  FrameId id;
  Camera camera;
  std::shared_ptr<const FrameFeatures> features;
};

// Reads the images of a folder and extracts their features as a frontend would, on num_threads
// threads; the n-th folder is the n-th drive. An image that cannot be read is named and taken out
// of images. Throws std::runtime_error where none can be read.
std::vector<PlaceImage> ExtractPlaceImages(PlaceImages* images, uint32_t folder,
                                           const FrontendOptions& options, int num_threads);

// How the queries are asked.
struct PlaceTrialOptions {
  bool use_prior = false;  // each after the one before it in its folder, as the node does
  // Queries are the database too, and know the images before them; of their own folder only those
  // that come at least so many images before. 0: queries do not know each other.
  size_t self_gap = 0;
  bool keep_scores = false;
};

// The best answers to each query, method by method, and what they cost.
struct PlaceTrial {
  std::vector<std::optional<PlaceAnswer>> fabmap;           // score: log of place against new place
  std::vector<std::optional<PlaceAnswer>> verified;         // after geometry; score: inliers
  std::vector<std::optional<PlaceAnswer>> tf_idf;           // score: similarity
  double words_ms = 0.0, fabmap_ms = 0.0, verify_ms = 0.0;  // processor time a query, mean
  double bytes_per_place = 0.0;
  PlaceCounters counters;
  // FAB-MAP's by query and database image, without the prior; -infinity: not known yet. If kept.
  std::vector<std::vector<double>> scores;
};

// With self_gap: whether query i knows image j of the queries.
bool KnowsImage(const std::vector<PlaceImage>& queries, size_t i, size_t j, size_t self_gap);

// Asks for every query among the database, which with self_gap begins with the queries.
PlaceTrial RunPlaceTrial(const std::vector<PlaceImage>& queries,
                         const std::vector<PlaceImage>& database,
                         const std::shared_ptr<const PlaceModel>& model,
                         const PlaceRecognizerOptions& options, const PlaceTrialOptions& trial);

}  // namespace rovio_sfm
