#include "rovio_sfm/recognition/place_recognizer_options.h"

#include <gtest/gtest.h>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

std::string ErrorOf(const PlaceRecognizerOptions& options) {
  std::string error;
  const bool is_valid = IsValid(options, &error);
  EXPECT_EQ(is_valid, error.empty());
  return error;
}

TEST(PlaceRecognizerOptions, DefaultsAreValid) { EXPECT_EQ(ErrorOf({}), ""); }

TEST(PlaceRecognizerOptions, NamesWhatIsOutOfRange) {
  PlaceRecognizerOptions options;
  options.candidates.max_candidates = 0;
  EXPECT_NE(ErrorOf(options).find("max_candidates"), std::string::npos);
}

TEST(PlaceRecognizerOptions, ChecksEveryGroup) {
  PlaceRecognizerOptions options;
  options.verify.pair.max_ratio = 2.0f;
  EXPECT_NE(ErrorOf(options).find("max_ratio"), std::string::npos);
  options = {};
  options.recent_past.min_keyframes = 0;
  EXPECT_NE(ErrorOf(options).find("min_keyframes"), std::string::npos);
  options = {};
  options.fabmap.new_place_prior = 0.0;
  EXPECT_NE(ErrorOf(options).find("new_place_prior"), std::string::npos);
}

TEST(PlaceRecognizerOptions, OverlapsAreLookedForMoreClosely) {
  const PlaceRecognizerOptions options;
  EXPECT_LT(options.overlap_candidates.min_score, options.candidates.min_score);
  EXPECT_GT(options.overlap_candidates.max_candidates, options.candidates.max_candidates);
}

}  // namespace
}  // namespace rovio_sfm
