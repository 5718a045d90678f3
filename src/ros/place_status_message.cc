#include "rovio_sfm/ros/place_status_message.h"

namespace rovio_sfm {

PlaceStatus ToMessage(const PlaceCounters& counters) {
  PlaceStatus message;
  message.num_light_frames = counters.light_frames;
  message.num_foreign_type = counters.foreign_type;
  message.num_queries = counters.queries;
  message.num_only_recent = counters.only_recent;
  message.num_low_score = counters.low_score;
  message.num_candidates = counters.candidates;
  message.num_out_of_reach = counters.out_of_reach;
  message.num_refused_geometry = counters.refused_geometry;
  message.num_refused_spread = counters.refused_spread;
  message.num_outdone = counters.outdone;
  message.num_matches = counters.matches;
  message.num_matched_queries = counters.matched_queries;
  message.num_pairs = counters.pairs;
  return message;
}

}  // namespace rovio_sfm
