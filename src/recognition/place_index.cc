#include "rovio_sfm/recognition/place_index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

// Every place whose flag is 0.
std::vector<uint32_t> PlacesNotIn(const std::vector<uint8_t>& is_allowed) {
  std::vector<uint32_t> places;
  for (uint32_t place = 0; place < is_allowed.size(); ++place) {
    if (is_allowed[place] == 0) places.push_back(place);
  }
  return places;
}

// Log likelihoods against a new place's, with the motion prior over an even one.
std::vector<double> RankingOf(const PlaceQuery& query, const FabmapResult& result) {
  std::vector<double> values = result.log_likelihoods;
  const auto num_places = static_cast<double>(values.size());
  for (size_t place = 0; place < values.size(); ++place) {
    values[place] -= result.new_place_log_likelihood;
    if (query.place_weights.empty()) continue;
    values[place] += std::log(num_places * query.place_weights[place]);  // 0 rules the place out
  }
  return values;
}

}  // namespace

PlaceIndex::PlaceIndex(std::shared_ptr<const PlaceModel> model,
                       const PlaceRecognizerOptions& options)
    : fabmap_(std::move(model), options.fabmap), motion_prior_(options.motion_prior) {}

void PlaceIndex::EnterDrive(const DriveId& drive, const Camera& camera) {
  Drive opened;
  opened.camera = camera;
  drives_.try_emplace(drive, std::move(opened));
}

std::optional<uint32_t> PlaceIndex::NewestOf(const DriveId& drive) const {
  const auto found = drives_.find(drive);
  if (found == drives_.end() || found->second.indices.empty()) return std::nullopt;
  return found->second.indices.back();
}

void PlaceIndex::Add(const FrameId& id, const std::vector<uint32_t>& words,
                     std::optional<FabmapResult> last) {
  const auto found = drives_.find(id.drive);
  ROVIO_CHECK(found != drives_.end(), "enter the drive first");
  Drive& drive = found->second;
  ROVIO_CHECK(drive.indices.empty() || drive.indices.back() < id.index, "indices must rise");
  motion_prior_.AddPlace(drive.places.empty() ? MotionPrior::kNoPlace : drive.places.back());
  const uint32_t place = fabmap_.AddPlace(words);
  places_.push_back({found, static_cast<uint32_t>(drive.indices.size())});
  drive.indices.push_back(id.index);
  drive.places.push_back(place);
  drive.last = std::move(last);
}

PlaceProposal PlaceIndex::Ask(const DriveId& drive_id, size_t num_allowed,
                              const std::vector<uint32_t>& words,
                              const CandidateOptions& options) const {
  const Drive& drive = drives_.at(drive_id);
  PlaceQuery query;
  query.words = words;
  if (num_allowed < drive.places.size()) {
    query.excluded_places.assign(drive.places.begin() + static_cast<long>(num_allowed),
                                 drive.places.end());
  }
  if (drive.last) query.place_weights = motion_prior_.Predict(*drive.last);
  return Propose(query, options);
}

PlaceProposal PlaceIndex::AskAmong(const std::vector<FrameId>& frames,
                                   const std::vector<uint32_t>& words,
                                   const CandidateOptions& options) const {
  std::vector<uint8_t> is_allowed(places_.size(), 0);
  for (const FrameId& id : frames) {
    const auto drive = drives_.find(id.drive);
    if (drive == drives_.end()) continue;
    const auto ordinal = OrdinalOf(drive->second, id.index);
    if (ordinal) is_allowed[drive->second.places[*ordinal]] = 1;
  }
  return Propose({words, PlacesNotIn(is_allowed), {}}, options);
}

PlaceProposal PlaceIndex::AskAll(const std::vector<uint32_t>& words,
                                 const CandidateOptions& options, const FabmapResult* last) const {
  PlaceQuery query{words, {}, {}};
  if (last != nullptr) query.place_weights = motion_prior_.Predict(*last);
  return Propose(query, options);
}

PlaceProposal PlaceIndex::Propose(const PlaceQuery& query, const CandidateOptions& options) const {
  PlaceProposal proposal;
  proposal.num_allowed = places_.size() - query.excluded_places.size();
  if (proposal.num_allowed == 0) return proposal;
  proposal.result = fabmap_.Query(query);
  if (proposal.result.score >= options.min_score) {
    proposal.candidates = Choose(query, proposal.result, options);
  }
  return proposal;
}

std::vector<PlaceCandidate> PlaceIndex::Choose(const PlaceQuery& query, const FabmapResult& result,
                                               const CandidateOptions& options) const {
  // Of one place at most so many keyframes stand before the next place in the ranking.
  const auto neighborhood = static_cast<size_t>(2 * options.same_place_keyframes + 1);
  const auto count = static_cast<size_t>(options.max_candidates);
  const std::vector<double> ranking = RankingOf(query, result);
  std::vector<uint32_t> chosen;
  std::vector<PlaceCandidate> candidates;
  for (const uint32_t place : BestPlaces(ranking, neighborhood * count)) {
    if (chosen.size() == count) break;
    const bool is_known = std::any_of(chosen.begin(), chosen.end(), [&](uint32_t other) {
      return AreOnePlace(place, other, options.same_place_keyframes);
    });
    if (is_known) continue;
    chosen.push_back(place);
    const Place& origin = places_[place];
    candidates.push_back({{origin.drive->first, origin.drive->second.indices[origin.ordinal]},
                          result.posteriors[place],
                          ranking[place]});
  }
  return candidates;
}

bool PlaceIndex::AreOnePlace(uint32_t a, uint32_t b, int distance) const {
  const int64_t ordinal_a = places_[a].ordinal;
  const int64_t ordinal_b = places_[b].ordinal;
  return places_[a].drive == places_[b].drive && std::abs(ordinal_a - ordinal_b) <= distance;
}

std::optional<size_t> PlaceIndex::OrdinalOf(const Drive& drive, uint32_t index) const {
  const auto found = std::lower_bound(drive.indices.begin(), drive.indices.end(), index);
  if (found == drive.indices.end() || *found != index) return std::nullopt;
  return static_cast<size_t>(found - drive.indices.begin());
}

const Camera* PlaceIndex::FindCamera(const FrameId& id) const {
  const auto drive = drives_.find(id.drive);
  const bool is_known = drive != drives_.end() && OrdinalOf(drive->second, id.index);
  return is_known ? &drive->second.camera : nullptr;
}

std::vector<FrameId> PlaceIndex::Neighbors(const FrameId& id, int step, size_t count) const {
  std::vector<FrameId> neighbors;
  const Drive& drive = drives_.at(id.drive);
  const std::optional<size_t> ordinal = OrdinalOf(drive, id.index);
  if (!ordinal) return neighbors;
  const auto end = static_cast<int64_t>(drive.indices.size());
  for (auto i = static_cast<int64_t>(*ordinal) + step; i >= 0 && i < end; i += step) {
    if (neighbors.size() == count) break;
    neighbors.push_back({id.drive, drive.indices[static_cast<size_t>(i)]});
  }
  return neighbors;
}

std::vector<FrameId> PlaceIndex::FramesBetween(const DriveId& drive, uint32_t first,
                                               uint32_t last) const {
  std::vector<FrameId> frames;
  const auto found = drives_.find(drive);
  if (found == drives_.end()) return frames;
  for (const uint32_t index : found->second.indices) {
    if (index >= first && index <= last) frames.push_back({drive, index});
  }
  return frames;
}

size_t PlaceIndex::NumBytes() const {
  size_t bytes = fabmap_.NumBytes() + places_.capacity() * sizeof(Place);
  for (const auto& [id, drive] : drives_) {
    bytes += (drive.indices.capacity() + drive.places.capacity()) * sizeof(uint32_t);
    if (drive.last) bytes += 2 * drive.last->posteriors.size() * sizeof(double);
  }
  return bytes;
}

}  // namespace rovio_sfm
