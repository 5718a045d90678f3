#include "rovio_sfm/recognition/verify_place.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "rovio_sfm/recognition/largest_features.h"
#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

constexpr int kCellsPerSide = 4;
constexpr int kLeastInliers = 8;  // that any pair may be asked for

// FNV-1a: the same with every standard library.
uint64_t HashOf(const std::string& text) {
  uint64_t hash = 14695981039346656037u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash;
}

Rng PairRng(uint64_t seed, const FrameId& candidate, const FrameId& query) {
  return Rng(seed).Fork(HashOf(candidate.ToString() + " " + query.ToString()));
}

// The focal length at which a pixel is as wide as the root mean square of both cameras' pixels.
double CommonFocal(const Camera& a, const Camera& b) {
  const double pixel_a = 1.0 / a.MeanFocal();
  const double pixel_b = 1.0 / b.MeanFocal();
  return 1.0 / std::sqrt(0.5 * (pixel_a * pixel_a + pixel_b * pixel_b));
}

int CellOf(float x_px, int size_px) {
  const int cell = static_cast<int>(kCellsPerSide * (x_px + 0.5f) / static_cast<float>(size_px));
  return std::clamp(cell, 0, kCellsPerSide - 1);
}

int CellOf(const Keypoint& keypoint, const Camera& camera) {
  return kCellsPerSide * CellOf(keypoint.y_px, camera.height) + CellOf(keypoint.x_px, camera.width);
}

bool IsSpread(const std::vector<FeatureMatch>& inliers, const PlaceFrame& candidate,
              const PlaceFrame& query, int min_cells) {
  std::set<int> cells_candidate, cells_query;
  for (const FeatureMatch& match : inliers) {
    cells_candidate.insert(CellOf(candidate.features->keypoints[match.a], candidate.camera));
    cells_query.insert(CellOf(query.features->keypoints[match.b], query.camera));
  }
  const auto count = static_cast<size_t>(min_cells);
  return cells_candidate.size() >= count && cells_query.size() >= count;
}

PairMatches MatchPlaces(const PlaceFrame& candidate, const PlaceFrame& query,
                        const PairOptions& options, uint64_t seed) {
  Rng rng = PairRng(seed, candidate.id, query.id);
  return MatchPair(candidate.id.index, *candidate.features, *query.features,
                   CommonFocal(candidate.camera, query.camera), options, rng);
}

PlaceFrame WithLargest(PlaceFrame frame, size_t count) {
  frame.features = LargestFeatures(frame.features, count);
  return frame;
}

// True where the largest features, which cost little to match, hold less than half a pair.
bool FailsAtAGlance(const PlaceFrame& candidate, const PlaceFrame& query,
                    const VerifyPlaceOptions& options, uint64_t seed) {
  const auto count = static_cast<size_t>(options.glance_features);
  if (candidate.features->keypoints.size() <= count) return false;
  if (query.features->keypoints.size() <= count) return false;
  PairOptions milder = options.pair;
  milder.use_guided = false;
  milder.verify.min_inliers = std::max(kLeastInliers, options.pair.verify.min_inliers / 2);
  return MatchPlaces(WithLargest(candidate, count), WithLargest(query, count), milder, seed)
             .verdict == PairVerdict::kFailed;
}

}  // namespace

PairOptions VerifyPlaceOptions::DefaultPair() {
  PairOptions pair;
  pair.max_ratio = 0.8f;
  return pair;
}

PlaceVerification VerifyPlace(const PlaceFrame& candidate, const PlaceFrame& query,
                              const VerifyPlaceOptions& options, uint64_t seed) {
  PlaceVerification verification;
  if (FailsAtAGlance(candidate, query, options, seed)) return verification;
  PairMatches pair = MatchPlaces(candidate, query, options.pair, seed);
  if (pair.verdict == PairVerdict::kFailed) return verification;
  verification.refusal = IsSpread(pair.inliers, candidate, query, options.min_cells)
                             ? PlaceRefusal::kNone
                             : PlaceRefusal::kSpread;
  verification.pair = {candidate.id, pair.verdict, pair.cam_from_other, std::move(pair.inliers)};
  return verification;
}

std::vector<OverlapPair> MatchAround(const std::vector<FrameId>& neighbors, const PlaceFrame& query,
                                     const FindPlaceFrame& find, const VerifyPlaceOptions& options,
                                     uint64_t seed) {
  std::vector<OverlapPair> pairs;
  for (const FrameId& id : neighbors) {
    if (pairs.size() == static_cast<size_t>(options.max_neighbors)) break;
    const std::optional<PlaceFrame> neighbor = find(id);
    if (!neighbor) break;
    PlaceVerification verification = VerifyPlace(*neighbor, query, options, seed);
    if (verification.refusal != PlaceRefusal::kNone) break;
    pairs.push_back(std::move(verification.pair));
  }
  return pairs;
}

}  // namespace rovio_sfm
