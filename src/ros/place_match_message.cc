#include "rovio_sfm/ros/place_match_message.h"

#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMaxPairs = 1000;

uint16_t ToIndex(uint32_t feature) {
  ROVIO_CHECK(feature <= std::numeric_limits<uint16_t>::max(), "a frame has too many features");
  return static_cast<uint16_t>(feature);
}

OverlapPairMsg ToMessage(const OverlapPair& pair) {
  OverlapPairMsg message;
  message.other = ToMessage(pair.other);
  message.verdict = static_cast<uint8_t>(pair.verdict);
  message.query_from_other = ToTransform(pair.query_from_other);
  for (const FeatureMatch& match : pair.inliers) {
    message.inlier_other.push_back(ToIndex(match.a));
    message.inlier_query.push_back(ToIndex(match.b));
  }
  return message;
}

bool RefuseField(const std::string& field, const std::string& expected, std::string* error) {
  *error = field + ": expected " + expected;
  return false;
}

// A translation is a direction, or nothing where the camera only turned.
bool IsConsistentPose(const OverlapPairMsg& message, const Rigid3& query_from_other,
                      std::string* error) {
  const double length = query_from_other.translation.norm();
  const bool is_direction = std::abs(length - 1.0) <= 1e-3;
  const bool is_rotation = length <= 1e-9 && message.verdict == OverlapPairMsg::ROTATION;
  return is_direction || is_rotation ||
         RefuseField("pairs.query_from_other", "a translation of length 1, or 0 with ROTATION",
                     error);
}

bool HasConsistentInliers(const OverlapPairMsg& message, std::string* error) {
  if (message.inlier_other.empty() || message.inlier_other.size() != message.inlier_query.size()) {
    return RefuseField("pairs.inlier_other", "as many entries as inlier_query, one at least",
                       error);
  }
  const std::set<uint16_t> others(message.inlier_other.begin(), message.inlier_other.end());
  const std::set<uint16_t> queries(message.inlier_query.begin(), message.inlier_query.end());
  return (others.size() == message.inlier_other.size() &&
          queries.size() == message.inlier_query.size()) ||
         RefuseField("pairs.inlier_query", "each feature once", error);
}

std::optional<OverlapPair> FromMessage(const OverlapPairMsg& message, std::string* error) {
  const std::optional<FrameId> other = FromMessage(message.other, error);
  if (!other) return std::nullopt;
  std::string reason;
  const std::optional<Rigid3> query_from_other = FromTransform(message.query_from_other, &reason);
  if (!query_from_other) {
    *error = "pairs.query_from_other: " + reason;
    return std::nullopt;
  }
  if (message.verdict < OverlapPairMsg::GENERAL || message.verdict > OverlapPairMsg::ROTATION) {
    RefuseField("pairs.verdict", "GENERAL, PLANAR or ROTATION", error);
    return std::nullopt;
  }
  if (!IsConsistentPose(message, *query_from_other, error)) return std::nullopt;
  if (!HasConsistentInliers(message, error)) return std::nullopt;
  OverlapPair pair{*other, static_cast<PairVerdict>(message.verdict), *query_from_other, {}};
  for (size_t i = 0; i < message.inlier_other.size(); ++i) {
    pair.inliers.push_back({message.inlier_other[i], message.inlier_query[i], 0.0f, 1.0f});
  }
  return pair;
}

bool HasConsistentScores(const PlaceMatchMsg& message, std::string* error) {
  if (!(message.probability >= 0.0 && message.probability <= 1.0 + 1e-9)) {
    return RefuseField("probability", "0 to 1", error);
  }
  if (!std::isfinite(message.score)) return RefuseField("score", "a finite number", error);
  if (message.pairs.empty() || message.pairs.size() > kMaxPairs) {
    return RefuseField("pairs", "1 to 1000", error);
  }
  return true;
}

}  // namespace

PlaceMatchMsg ToMessage(const PlaceMatch& match, int64_t stamp_ns) {
  PlaceMatchMsg message;
  message.header.stamp = ToTime(stamp_ns);
  message.query = ToMessage(match.query);
  message.probability = match.probability;
  message.score = match.score;
  for (const OverlapPair& pair : match.pairs) message.pairs.push_back(ToMessage(pair));
  return message;
}

std::optional<PlaceMatch> FromMessage(const PlaceMatchMsg& message, std::string* error) {
  const std::optional<FrameId> query = FromMessage(message.query, error);
  if (!query || !HasConsistentScores(message, error)) return std::nullopt;
  PlaceMatch match{*query, message.probability, message.score, {}};
  for (const OverlapPairMsg& pair_message : message.pairs) {
    std::optional<OverlapPair> pair = FromMessage(pair_message, error);
    if (!pair) return std::nullopt;
    if (pair->other == *query) {
      RefuseField("pairs.other", "another frame than the query", error);
      return std::nullopt;
    }
    match.pairs.push_back(std::move(*pair));
  }
  return match;
}

}  // namespace rovio_sfm
