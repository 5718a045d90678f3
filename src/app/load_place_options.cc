#include "rovio_sfm/app/load_options.h"

namespace rovio_sfm {
namespace {

void ReadFabmap(OptionReader reader, FabmapOptions* options) {
  reader.ReadChoice(
      "new_place_model",
      {{"mean_field", NewPlaceModel::kMeanField}, {"sampled", NewPlaceModel::kSampled}},
      &options->new_place_model);
  reader.Read("new_place_prior", &options->new_place_prior);
  reader.RefuseUnknown();
}

void ReadMotionPrior(OptionReader reader, MotionPriorOptions* options) {
  reader.Read("move_probability", &options->move_probability);
  reader.Read("uniform_share", &options->uniform_share);
  reader.RefuseUnknown();
}

void ReadCandidates(OptionReader reader, CandidateOptions* options) {
  reader.Read("min_score", &options->min_score);
  reader.Read("max_candidates", &options->max_candidates);
  reader.Read("same_place_keyframes", &options->same_place_keyframes);
  reader.RefuseUnknown();
}

void ReadRecentPast(OptionReader reader, RecentPastOptions* options) {
  reader.Read("min_keyframes", &options->min_keyframes);
  reader.Read("min_shared_tracks", &options->min_shared_tracks);
  reader.RefuseUnknown();
}

void ReadVerifyPlace(OptionReader reader, VerifyPlaceOptions* options) {
  OptionReader pair = reader.Group("pair");
  ReadOptions(&pair, &options->pair);
  reader.Read("min_cells", &options->min_cells);
  reader.Read("max_neighbors", &options->max_neighbors);
  reader.RefuseUnknown();
}

}  // namespace

void ReadOptions(OptionReader* reader, PlaceRecognizerOptions* options) {
  ReadFabmap(reader->Group("fabmap"), &options->fabmap);
  ReadMotionPrior(reader->Group("motion_prior"), &options->motion_prior);
  ReadCandidates(reader->Group("candidates"), &options->candidates);
  ReadCandidates(reader->Group("overlap_candidates"), &options->overlap_candidates);
  ReadRecentPast(reader->Group("recent_past"), &options->recent_past);
  ReadVerifyPlace(reader->Group("verify"), &options->verify);
  reader->Read("seed", &options->seed);
  reader->RefuseUnknown();
  RequireValid(*options);
}

}  // namespace rovio_sfm
