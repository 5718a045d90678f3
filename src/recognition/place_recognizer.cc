#include "rovio_sfm/recognition/place_recognizer.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "rovio_sfm/recognition/largest_features.h"

namespace rovio_sfm {

PlaceRecognizer::PlaceRecognizer(const PlaceRecognizerOptions& options,
                                 std::shared_ptr<const PlaceModel> model, const FrameStore* store,
                                 StageTimes* times)
    : options_(options), model_(model), store_(store), times_(times), index_(model, options) {}

std::vector<PlaceMatch> PlaceRecognizer::Add(const FrameEvent& event) {
  if (!Enter(event)) return {};
  const std::vector<uint32_t> words = WordsOf(event.features);
  const size_t num_allowed = recent_.at(event.id.drive).Add(event.tracks, event.links);
  const PlaceProposal proposal =
      index_.Ask(event.id.drive, num_allowed, words, options_.candidates);
  const std::vector<PlaceMatch> matches = Match({event.id, event.features, event.camera}, proposal);
  index_.Add(event.id, words, proposal.result);
  return matches;
}

void PlaceRecognizer::Remember(const FrameEvent& event) {
  if (!Enter(event)) return;
  recent_.at(event.id.drive).Add(event.tracks, event.links);
  index_.Add(event.id, WordsOf(event.features), std::nullopt);
}

void PlaceRecognizer::EndRecentPast(const DriveId& drive, size_t num_kept) {
  const auto recent = recent_.find(drive);
  if (recent != recent_.end()) recent->second.Break(num_kept);
}

// False for what is not to be asked for.
bool PlaceRecognizer::Enter(const FrameEvent& event) {
  if (event.kind == FrameKind::kLight) {
    ++counters_.light_frames;
    return false;
  }
  std::string reason;
  if (!model_->vocabulary.Accepts(event.features->descriptors, &reason)) {
    return CountRefused(&counters_.foreign_type, event.id.ToString() + ": " + reason);
  }
  const std::optional<uint32_t> newest = index_.NewestOf(event.id.drive);
  if (newest && *newest >= event.id.index) {
    return CountRefused(&counters_.out_of_order, event.id.ToString() + ": frame " +
                                                     std::to_string(*newest) +
                                                     " of the drive is known already");
  }
  index_.EnterDrive(event.id.drive, event.camera);
  recent_.try_emplace(event.id.drive, options_.recent_past);
  return true;
}

bool PlaceRecognizer::CountRefused(uint64_t* counter, const std::string& reason) {
  ++*counter;
  last_refusal_ = reason;
  return false;
}

std::vector<PlaceMatch> PlaceRecognizer::FindOverlaps(const std::vector<FrameId>& queries,
                                                      const std::vector<FrameId>& others) {
  const std::set<FrameId> query_ids(queries.begin(), queries.end());
  std::vector<PlaceMatch> matches;
  for (const FrameId& id : query_ids) {
    const std::optional<PlaceFrame> query = FindFrame(id);
    if (!query) continue;
    const PlaceProposal proposal =
        index_.AskAmong(WithoutRecent(others, id, query_ids), WordsOf(query->features),
                        options_.overlap_candidates);
    for (PlaceMatch& match : Match(*query, proposal)) matches.push_back(std::move(match));
  }
  return matches;
}

// Without the frame itself and those of the queries that are less than min_keyframes away from it.
std::vector<FrameId> PlaceRecognizer::WithoutRecent(const std::vector<FrameId>& frames,
                                                    const FrameId& id,
                                                    const std::set<FrameId>& queries) const {
  std::set<FrameId> near{id};
  for (const int step : {-1, 1}) {
    const auto count = static_cast<size_t>(options_.recent_past.min_keyframes);
    for (const FrameId& neighbor : index_.Neighbors(id, step, count)) {
      if (queries.count(neighbor) > 0) near.insert(neighbor);
    }
  }
  std::vector<FrameId> left;
  std::copy_if(frames.begin(), frames.end(), std::back_inserter(left),
               [&](const FrameId& frame) { return near.count(frame) == 0; });
  return left;
}

std::vector<PlaceMatch> PlaceRecognizer::QueryImage(std::shared_ptr<const FrameFeatures> features,
                                                    const Camera& camera,
                                                    const FabmapResult* last) {
  std::string reason;
  if (!model_->vocabulary.Accepts(features->descriptors, &reason)) {
    CountRefused(&counters_.foreign_type, "image: " + reason);
    return {};
  }
  const PlaceProposal proposal = index_.AskAll(WordsOf(features), options_.candidates, last);
  return Match({FrameId{}, std::move(features), camera}, proposal);
}

std::vector<uint32_t> PlaceRecognizer::WordsOf(
    const std::shared_ptr<const FrameFeatures>& features) const {
  const StageTimes::Scope scope = MeasureStage(times_, "place words");
  const auto count = static_cast<size_t>(options_.max_features);
  return model_->vocabulary.Quantize(LargestFeatures(features, count)->descriptors);
}

std::vector<PlaceMatch> PlaceRecognizer::Match(const PlaceFrame& query,
                                               const PlaceProposal& proposal) {
  const StageTimes::Scope scope = MeasureStage(times_, "place verification");
  ++counters_.queries;
  if (proposal.num_allowed == 0) ++counters_.only_recent;
  if (proposal.num_allowed > 0 && proposal.candidates.empty()) ++counters_.low_score;
  std::vector<PlaceMatch> matches;
  for (const PlaceCandidate& candidate : proposal.candidates) {
    ++counters_.candidates;
    std::optional<OverlapPair> pair = Verify(query, candidate.id);
    if (!pair) continue;
    KeepBest({query.id, candidate.probability, proposal.result.score, {std::move(*pair)}},
             &matches);
  }
  for (PlaceMatch& match : matches) AddAround(query, &match);
  if (!matches.empty()) ++counters_.matched_queries;
  return matches;
}

std::optional<OverlapPair> PlaceRecognizer::Verify(const PlaceFrame& query, const FrameId& other) {
  const std::optional<PlaceFrame> frame = FindFrame(other);
  if (!frame) {
    ++counters_.out_of_reach;
    return std::nullopt;
  }
  PlaceVerification verification = VerifyPlace(*frame, query, options_.verify, options_.seed);
  if (!IsAccepted(verification)) return std::nullopt;
  return std::move(verification.pair);
}

// Of several matches with one drive the one with most inliers stays: a repeated object may have
// been proposed before the place itself.
void PlaceRecognizer::KeepBest(PlaceMatch match, std::vector<PlaceMatch>* matches) {
  const auto rival = std::find_if(matches->begin(), matches->end(), [&](const PlaceMatch& other) {
    return other.pairs.front().other.drive == match.pairs.front().other.drive;
  });
  if (rival == matches->end()) {
    matches->push_back(std::move(match));
    return;
  }
  ++counters_.outdone;
  if (match.pairs.front().inliers.size() > rival->pairs.front().inliers.size()) {
    *rival = std::move(match);
  }
}

bool PlaceRecognizer::IsAccepted(const PlaceVerification& verification) {
  if (verification.refusal == PlaceRefusal::kGeometry) ++counters_.refused_geometry;
  if (verification.refusal == PlaceRefusal::kSpread) ++counters_.refused_spread;
  return verification.refusal == PlaceRefusal::kNone;
}

// The frames before and after the matched one (§4.3.1).
void PlaceRecognizer::AddAround(const PlaceFrame& query, PlaceMatch* match) {
  const FrameId center = match->pairs.front().other;
  const auto count = static_cast<size_t>(options_.verify.max_neighbors);
  const FindPlaceFrame find = [&](const FrameId& id) {
    return id == query.id ? std::nullopt : FindFrame(id);
  };
  for (const int step : {-1, 1}) {
    for (OverlapPair& pair : MatchAround(index_.Neighbors(center, step, count), query, find,
                                         options_.verify, options_.seed)) {
      match->pairs.push_back(std::move(pair));
    }
  }
  ++counters_.matches;
  counters_.pairs += match->pairs.size();
}

std::optional<PlaceFrame> PlaceRecognizer::FindFrame(const FrameId& id) const {
  const Camera* camera = index_.FindCamera(id);
  if (camera == nullptr) return std::nullopt;
  std::shared_ptr<const FrameFeatures> features = store_->Get(id);
  if (features == nullptr || features->descriptors.Count() == 0) return std::nullopt;
  return PlaceFrame{id, std::move(features), *camera};
}

}  // namespace rovio_sfm
