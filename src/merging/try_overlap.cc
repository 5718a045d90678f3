#include "rovio_sfm/merging/try_overlap.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "rovio_sfm/merging/align_overlap.h"
#include "rovio_sfm/merging/map_bundle.h"
#include "rovio_sfm/merging/match_across_break.h"

namespace rovio_sfm {
namespace {

constexpr double kProvenScale = 0.02;  // of an alignment that needs no more proof
constexpr uint32_t kLoopReach = 20;    // indices round the other frame in which a loop is searched

// The keyframe and its neighbours in the session, `count` on both sides.
std::vector<uint32_t> FramesAround(const Session& session, uint32_t frame, int count) {
  std::vector<uint32_t> frames;
  const auto& keyframes = session.keyframes();
  auto first = keyframes.find(frame), last = first;
  for (int i = 0; i < count && first != keyframes.begin(); ++i) --first;
  for (int i = 0; i < count && std::next(last) != keyframes.end(); ++i) ++last;
  for (auto it = first; it != std::next(last); ++it) {
    if (!it->second.weak) frames.push_back(it->first);
  }
  return frames;
}

// In a loop only the old part of the session is looked for.
FrameRange RangeOf(const Session& a, const Session& b, uint32_t frame) {
  if (&a != &b) return {};
  return {frame > kLoopReach ? frame - kLoopReach : 0, frame + kLoopReach};
}

std::vector<FeatureLink> Reversed(std::vector<FeatureLink> links) {
  for (FeatureLink& link : links) std::swap(link.a, link.b);
  return links;
}

std::vector<FeatureLink> LinksOf(const Session& a, const Session& b,
                                 const std::vector<CrossMatch>& matches) {
  std::vector<FeatureLink> links;
  for (const CrossMatch& match : matches) {
    links.push_back({{a.id(), match.a.observation.frame, match.a.observation.feature},
                     {b.id(), match.b.observation.frame, match.b.observation.feature}});
  }
  return links;
}

void Unify(std::vector<FeatureLink>* links) {
  std::sort(links->begin(), links->end());
  links->erase(std::unique(links->begin(), links->end()), links->end());
}

// Landmarks of both sessions in the other's frames around the overlap.
std::vector<FeatureLink> SearchAround(const Session& a, const Session& b, uint32_t query,
                                      uint32_t other, const Sim3& b_from_a,
                                      const MergeOptions& options, const FrameStore& store) {
  std::vector<FeatureLink> links;
  for (const uint32_t frame : FramesAround(b, query, options.search_neighbours)) {
    const auto found =
        SearchAcross(a, RangeOf(a, b, other), b, frame, b_from_a, options.search, store).links;
    links.insert(links.end(), found.begin(), found.end());
  }
  for (const uint32_t frame : FramesAround(a, other, options.search_neighbours)) {
    const auto found = Reversed(
        SearchAcross(b, RangeOf(a, b, query), a, frame, Inverse(b_from_a), options.search, store)
            .links);
    links.insert(links.end(), found.begin(), found.end());
  }
  return links;
}

void FillReport(const OverlapAlignment& aligned, MergeReport* report) {
  report->num_matches = static_cast<uint32_t>(aligned.num_matches);
  report->reason = aligned.reason;
  if (!aligned.alignment) return;
  report->num_inliers = static_cast<uint32_t>(aligned.inliers.size());
  report->num_common = static_cast<uint32_t>(aligned.alignment->num_common);
  report->by_resection = aligned.alignment->by_resection;
  report->query_from_other = aligned.alignment->b_from_a;
  report->sigma_log_scale = aligned.alignment->sigma_log_scale;
}

// Aligns anew with everything that a search around the overlap finds, where that works.
void SearchAndAlign(const Session& a, const Session& b, const MapOptions& options,
                    const FrameStore& store, OverlapTrial* trial) {
  MergeReport& report = trial->report;
  const auto found = SearchAround(a, b, report.query.index, report.other.index,
                                  report.query_from_other, options.merge, store);
  trial->links.insert(trial->links.end(), found.begin(), found.end());
  Unify(&trial->links);
  const OverlapAlignment again = AlignLinks(a, b, trial->links, report.query_from_other, options);
  if (!again.alignment) return;
  const bool by_resection = report.by_resection;
  const uint32_t num_matches = report.num_matches;
  FillReport(again, &report);
  report.by_resection = by_resection;
  report.num_matches = num_matches;
  trial->links = LinksOf(a, b, again.inliers);
  Unify(&trial->links);
}

// The depth of what a link shows in the query camera, in units of session a.
std::optional<double> DepthInQuery(const Session& a, const Session& b, const FeatureLink& link,
                                   const Sim3& b_from_a, const Rigid3& query_from_a) {
  const Landmark* landmark_a = ObservedLandmark(a, link.a);
  const Landmark* landmark_b = ObservedLandmark(b, link.b);
  if (landmark_a == nullptr && landmark_b == nullptr) return std::nullopt;
  const Eigen::Vector3d x_in_a =
      landmark_a != nullptr ? landmark_a->position : Inverse(b_from_a) * landmark_b->position;
  const double depth = (query_from_a * x_in_a).z();
  return depth > 0.0 ? std::optional<double>(depth) : std::nullopt;
}

std::vector<EvidenceInlier> InliersOf(const Session& a, const Session& b,
                                      const OverlapTrial& trial) {
  const Keyframe& query = b.keyframe(trial.report.query.index);
  const Sim3& b_from_a = trial.report.query_from_other;
  const Rigid3 query_from_a = TransformCamera(Inverse(b_from_a), query.cam_from_session);
  std::map<uint32_t, EvidenceInlier> inliers;  // by feature
  for (const FeatureLink& link : trial.links) {
    if (link.b.frame != trial.report.query.index) continue;
    const auto depth = DepthInQuery(a, b, link, b_from_a, query_from_a);
    if (depth) inliers[link.b.feature] = {query.points[link.b.feature], *depth};
  }
  std::vector<EvidenceInlier> list;
  for (const auto& [feature, inlier] : inliers) list.push_back(inlier);
  return list;
}

// What the frames beside the query say about the scale, each by itself.
std::vector<double> NeighbourScales(const Session& a, const Session& b, const OverlapTrial& trial,
                                    const MapOptions& options) {
  std::map<uint32_t, std::vector<FeatureLink>> links;  // by frame of b
  for (const FeatureLink& link : trial.links) {
    if (link.b.frame != trial.report.query.index) links[link.b.frame].push_back(link);
  }
  const double max_sigma = options.merge.evidence.max_sigma_log_scale;
  std::vector<double> log_scales;
  for (const auto& [frame, of_frame] : links) {
    const auto aligned = AlignLinks(a, b, of_frame, trial.report.query_from_other, options);
    if (!aligned.alignment || aligned.alignment->sigma_log_scale > max_sigma) continue;
    log_scales.push_back(
        std::log(aligned.alignment->b_from_a.scale / trial.report.query_from_other.scale));
  }
  return log_scales;
}

// Whether the frontend itself matched the two frames, as it does with those that follow one another
// in a drive: what they show is one place, so that an alignment that is certain needs no more
// proof.
bool IsContinuation(const Session& a, const Session& b, const MergeReport& report,
                    const MapOptions& options) {
  return &a != &b &&
         report.num_inliers >= static_cast<uint32_t>(options.merge.evidence.min_inliers) &&
         report.sigma_log_scale <= kProvenScale &&
         CountSharedTracks(a, report.other.index, b, report.query.index) >= kMinSharedTracks;
}

// Judges by what the query frame shows of the other session's landmarks.
void Judge(const Session& a, const Session& b, const std::vector<double>& neighbour_log_scales,
           const MapOptions& options, const FrameStore& store, OverlapTrial* trial) {
  MergeReport& report = trial->report;
  const AcrossReport seen =
      SearchAcross(a, RangeOf(a, b, report.other.index), b, report.query.index,
                   report.query_from_other, options.merge.search, store);
  report.num_expected = seen.num_expected;
  report.num_found = seen.num_found;
  report.num_links = static_cast<uint32_t>(trial->links.size());
  OverlapEvidence evidence;
  evidence.camera = b.camera();
  evidence.inliers = InliersOf(a, b, *trial);
  evidence.num_visible = static_cast<int>(seen.num_expected);
  evidence.num_visible_matched = static_cast<int>(seen.num_found);
  evidence.num_wide = static_cast<int>(seen.num_wide);
  evidence.num_wide_matched = static_cast<int>(seen.num_wide_found);
  evidence.sigma_log_scale = a.scale() && b.scale() ? 0.0 : report.sigma_log_scale;
  evidence.neighbour_log_scales = neighbour_log_scales;
  const EvidenceVerdict verdict = JudgeOverlap(evidence, options.merge.evidence);
  report.verdict = verdict.verdict;
  report.reason = verdict.text;
  const bool is_open = verdict.verdict == MergeVerdict::kProvisional &&
                       verdict.reason != EvidenceReason::kNeighboursDisagree;
  if (!is_open || !IsContinuation(a, b, report, options)) return;
  report.verdict = MergeVerdict::kAccepted;
  report.reason = "frames that follow one another in a drive; " + verdict.text;
}

}  // namespace

OverlapTrial TryOverlap(const Session& a, const Session& b, const FrameId& query,
                        const std::vector<OverlapPair>& pairs, const MapOptions& options,
                        const FrameStore& store) {
  OverlapTrial trial;
  MergeReport& report = trial.report;
  report.query = query;
  report.other = pairs.front().other;
  report.query_session = b.id();
  report.other_session = a.id();
  report.num_candidates = static_cast<uint32_t>(pairs.size());
  report.verdict = MergeVerdict::kRefused;
  const OverlapAlignment aligned = AlignOverlap(a, b, query.index, pairs, options);
  FillReport(aligned, &report);
  trial.needs_scale = aligned.needs_scale;
  if (!aligned.alignment) return trial;
  trial.links = LinksOf(a, b, aligned.inliers);
  Judge(a, b, {}, options, store, &trial);
  if (report.verdict == MergeVerdict::kRefused) return trial;  // the search would cost most
  SearchAndAlign(a, b, options, store, &trial);
  Judge(a, b, NeighbourScales(a, b, trial, options), options, store, &trial);
  return trial;
}

}  // namespace rovio_sfm
