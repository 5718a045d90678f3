#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "rovio_sfm/places/fabmap.h"
#include "rovio_sfm/places/motion_prior.h"
#include "rovio_sfm/recognition/place_recognizer_options.h"
#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {

// A keyframe that appearance proposes, with the posterior of its place, and what it is ranked by:
// its log likelihood against a new place's, with the motion prior over an even one.
struct PlaceCandidate {
  FrameId id;
  double probability = 0.0;
  double score = 0.0;
};

// What an image's words say, and the candidates, best first.
struct PlaceProposal {
  FabmapResult result;
  size_t num_allowed = 0;  // places that may be an answer
  std::vector<PlaceCandidate> candidates;
};

// The keyframes of all drives by their words. Holds words and cameras, no descriptors.
// Thread-compatible; depends on the order of the calls alone.
class PlaceIndex {
 public:
  PlaceIndex(std::shared_ptr<const PlaceModel> model, const PlaceRecognizerOptions& options);
  PlaceIndex(const PlaceIndex&) = delete;  // places point into drives
  PlaceIndex& operator=(const PlaceIndex&) = delete;

  // Opens a drive, if it is new.
  void EnterDrive(const DriveId& drive, const Camera& camera);
  bool KnowsDrive(const DriveId& drive) const { return drives_.count(drive) > 0; }
  // The index of the drive's newest keyframe; nothing for a drive without one.
  std::optional<uint32_t> NewestOf(const DriveId& drive) const;

  // The next keyframe of its drive, which is open; ids rise within a drive. last is what its words
  // said: the motion prior of the drive's next keyframe.
  void Add(const FrameId& id, const std::vector<uint32_t>& words, std::optional<FabmapResult> last);

  // Asks for the words of a keyframe of an open drive, of whose places the first num_allowed may be
  // an answer, with the motion prior of that drive.
  PlaceProposal Ask(const DriveId& drive, size_t num_allowed, const std::vector<uint32_t>& words,
                    const CandidateOptions& options) const;
  // Asks without a prior among the frames given; unknown ones are ignored.
  PlaceProposal AskAmong(const std::vector<FrameId>& frames, const std::vector<uint32_t>& words,
                         const CandidateOptions& options) const;
  // Asks among all, with the motion prior after `last` if there is one.
  PlaceProposal AskAll(const std::vector<uint32_t>& words, const CandidateOptions& options,
                       const FabmapResult* last = nullptr) const;

  // The camera of a frame's drive; null if the frame is not known.
  const Camera* FindCamera(const FrameId& id) const;
  // Known neighbours of a frame in its drive, nearest first, before (step -1) or after it (+1).
  std::vector<FrameId> Neighbors(const FrameId& id, int step, size_t count) const;

  // The known keyframes of a drive from index first to last.
  std::vector<FrameId> FramesBetween(const DriveId& drive, uint32_t first, uint32_t last) const;

  size_t NumDrives() const { return drives_.size(); }
  size_t NumPlaces() const { return places_.size(); }
  size_t NumBytes() const;  // memory that grows with the places

 private:
  struct Drive {
    Camera camera;
    std::vector<uint32_t> indices;  // FrameId::index of its keyframes, rising
    std::vector<uint32_t> places;   // their places
    std::optional<FabmapResult> last;
  };
  struct Place {
    std::map<DriveId, Drive>::const_iterator drive;
    uint32_t ordinal = 0;  // of the keyframe in its drive
  };

  // The keyframe's place in Drive::indices; nothing where it is not known.
  std::optional<size_t> OrdinalOf(const Drive& drive, uint32_t index) const;
  PlaceProposal Propose(const PlaceQuery& query, const CandidateOptions& options) const;
  std::vector<PlaceCandidate> Choose(const PlaceQuery& query, const FabmapResult& result,
                                     const CandidateOptions& options) const;
  bool AreOnePlace(uint32_t a, uint32_t b, int distance) const;

  Fabmap fabmap_;
  MotionPrior motion_prior_;
  std::map<DriveId, Drive> drives_;
  std::vector<Place> places_;
};

}  // namespace rovio_sfm
