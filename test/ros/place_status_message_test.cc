#include "rovio_sfm/ros/place_status_message.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(PlaceStatusMessage, CarriesEveryCount) {
  PlaceCounters c;
  c.light_frames = 1;
  c.foreign_type = 2;
  c.queries = 4;
  c.only_recent = 5;
  c.low_score = 6;
  c.candidates = 7;
  c.out_of_reach = 8;
  c.refused_geometry = 9;
  c.refused_spread = 10;
  c.outdone = 11;
  c.matches = 14;
  c.matched_queries = 12;
  c.pairs = 13;
  const PlaceStatus m = ToMessage(c);
  EXPECT_EQ(
      (std::vector<uint64_t>{m.num_light_frames, m.num_foreign_type, m.num_queries,
                             m.num_only_recent, m.num_low_score, m.num_candidates,
                             m.num_out_of_reach, m.num_refused_geometry, m.num_refused_spread,
                             m.num_outdone, m.num_matches, m.num_matched_queries, m.num_pairs}),
      (std::vector<uint64_t>{1, 2, 4, 5, 6, 7, 8, 9, 10, 11, 14, 12, 13}));
}

}  // namespace
}  // namespace rovio_sfm
