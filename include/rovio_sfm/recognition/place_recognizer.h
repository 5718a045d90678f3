#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "rovio_sfm/recognition/place_index.h"
#include "rovio_sfm/recognition/place_recognizer_options.h"
#include "rovio_sfm/recognition/recent_past.h"
#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/scene/frame_store.h"
#include "rovio_sfm/scene/place_match.h"
#include "rovio_sfm/util/stage_times.h"

namespace rovio_sfm {

// What became of all that was asked, stage by stage, so that "why no match?" has an answer.
struct PlaceCounters {
  uint64_t light_frames = 0;      // events ignored: light frames are never matched
  uint64_t foreign_type = 0;      // keyframes whose descriptors the vocabulary does not know
  uint64_t out_of_order = 0;      // keyframes known already, or older than their drive's newest
  uint64_t queries = 0;           // asked for their place: keyframes, overlaps and images
  uint64_t only_recent = 0;       // of them: nothing known but the own recent past
  uint64_t low_score = 0;         // of them: nothing looked alike enough to be verified
  uint64_t candidates = 0;        // frames that appearance proposed
  uint64_t out_of_reach = 0;      // of them: the store has no features
  uint64_t refused_geometry = 0;  // of them: too few inliers
  uint64_t refused_spread = 0;    // of them: the inliers crowd in a part of the image
  uint64_t outdone = 0;           // of them: another frame of the same drive matched better
  uint64_t matches = 0;           // of them: one per query and drive at most
  uint64_t matched_queries = 0;   // queries with a match or more
  uint64_t pairs = 0;             // frames in matches, those around the matched one included
};

// Recognises places by FAB-MAP and epipolar geometry (§4.2), for any number of drives at once in
// any interleaving. Keeps words, not descriptors: those come by id from the store. Results depend
// on the order of the calls and the options alone. Thread-compatible.
class PlaceRecognizer {
 public:
  // Options must be valid. The store and the times (may be null) outlive the recognizer.
  PlaceRecognizer(const PlaceRecognizerOptions& options, std::shared_ptr<const PlaceModel> model,
                  const FrameStore* store, StageTimes* times = nullptr);

  // Asks for the place of a keyframe, then remembers it: one match at most with each drive, its own
  // included, most likely first. Light frames are ignored; what else is, last_refusal explains.
  std::vector<PlaceMatch> Add(const FrameEvent& event);
  // Remembers a keyframe without asking.
  void Remember(const FrameEvent& event);

  // The drive's session was lost; the newest num_kept keyframes belong to the next one. Its frames
  // may match those of the lost one at once.
  void EndRecentPast(const DriveId& drive, size_t num_kept);

  // Looks for the places of `queries` among `others`, all of them known keyframes, with the lower
  // thresholds of options.overlap_candidates. Queries that are near in their drive are no overlap.
  std::vector<PlaceMatch> FindOverlaps(const std::vector<FrameId>& queries,
                                       const std::vector<FrameId>& others);

  // The places of an image that is no frame, with the motion prior after `last` if there is one;
  // the matches' query is the empty FrameId.
  std::vector<PlaceMatch> QueryImage(std::shared_ptr<const FrameFeatures> features,
                                     const Camera& camera, const FabmapResult* last = nullptr);

  // What an image is asked for and remembered by: the words of its largest features.
  std::vector<uint32_t> WordsOf(const std::shared_ptr<const FrameFeatures>& features) const;

  const PlaceCounters& counters() const { return counters_; }
  void ResetCounters() { counters_ = {}; }
  const std::string& last_refusal() const { return last_refusal_; }
  const PlaceIndex& index() const { return index_; }

 private:
  bool Enter(const FrameEvent& event);
  bool CountRefused(uint64_t* counter, const std::string& reason);
  std::vector<FrameId> WithoutRecent(const std::vector<FrameId>& frames, const FrameId& id,
                                     const std::set<FrameId>& queries) const;
  std::vector<PlaceMatch> Match(const PlaceFrame& query, const PlaceProposal& proposal);
  std::optional<OverlapPair> Verify(const PlaceFrame& query, const FrameId& other);
  bool IsAccepted(const PlaceVerification& verification);
  void KeepBest(PlaceMatch match, std::vector<PlaceMatch>* matches);
  void AddAround(const PlaceFrame& query, PlaceMatch* match);
  std::optional<PlaceFrame> FindFrame(const FrameId& id) const;

  PlaceRecognizerOptions options_;
  std::shared_ptr<const PlaceModel> model_;
  const FrameStore* store_;
  StageTimes* times_;
  PlaceIndex index_;
  std::map<DriveId, RecentPast> recent_;
  PlaceCounters counters_;
  std::string last_refusal_;
};

}  // namespace rovio_sfm
