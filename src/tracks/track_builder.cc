#include "rovio_sfm/tracks/track_builder.h"

#include <algorithm>

#include "rovio_sfm/util/check.h"
#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

bool HasMemberIn(const std::vector<TrackMember>& members, uint32_t frame) {
  return !members.empty() && members.back().frame == frame;
}

// The members of both, sorted by frame and feature.
std::vector<TrackMember> MergeMembers(const std::vector<TrackMember>& a,
                                      const std::vector<TrackMember>& b) {
  std::vector<TrackMember> merged;
  merged.reserve(a.size() + b.size());
  std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(merged),
             [](const TrackMember& x, const TrackMember& y) {
               return std::pair(x.frame, x.feature) < std::pair(y.frame, y.feature);
             });
  return merged;
}

}  // namespace

TrackBuilder::TrackBuilder(const TrackOptions& options) { SetOptions(options); }

void TrackBuilder::SetOptions(const TrackOptions& options) {
  std::string error;
  ROVIO_CHECK(IsValid(options, &error), error);
  options_ = options;
}

TrackUpdate TrackBuilder::Add(uint32_t frame_index,
                              const std::vector<Eigen::Vector2f>& keypoints_px,
                              const std::vector<PairMatches>& pairs) {
  ROVIO_CHECK(frames_.empty() || frame_index > frames_.back().index);
  TrackUpdate update;
  update.tracks.assign(keypoints_px.size(), 0);
  FrameTable frame{frame_index, keypoints_px, update.tracks};
  for (const PairMatches& pair : pairs) {
    const FrameTable* other = FindFrame(pair.other_index);
    if (other == nullptr) {
      update.counts.unknown += static_cast<uint32_t>(pair.inliers.size());
      continue;
    }
    for (const FeatureMatch& match : pair.inliers) {
      ROVIO_CHECK(match.a < other->tracks.size() && match.b < frame.tracks.size());
      AddMatch(other->tracks[match.a], match.b, &frame, &update);
    }
  }
  BeginTracks(&frame, &update);
  frames_.push_back(std::move(frame));
  ForgetOldFrames();
  return update;
}

TrackBuilder::FrameTable* TrackBuilder::FindFrame(uint32_t index) {
  const auto it = std::lower_bound(
      frames_.begin(), frames_.end(), index,
      [](const FrameTable& frame, uint32_t wanted) { return frame.index < wanted; });
  return it != frames_.end() && it->index == index ? &*it : nullptr;
}

void TrackBuilder::AddMatch(TrackId track_a, uint32_t feature_b, FrameTable* frame,
                            TrackUpdate* update) {
  const TrackId track_b = frame->tracks[feature_b];
  if (track_b == 0) {
    Join(track_a, feature_b, frame, update);
  } else if (track_a == track_b) {
    ++update->counts.agreed;
  } else {
    Link(track_a, track_b, frame, update);
  }
}

// Puts a feature of the new frame that has no track yet into one.
void TrackBuilder::Join(TrackId track, uint32_t feature, FrameTable* frame, TrackUpdate* update) {
  std::vector<TrackMember>& members = members_[track];
  const TrackMember member{frame->index, feature, frame->keypoints_px[feature]};
  if (!PassesFilterF1(members, {member}, options_.same_feature_px)) {
    ++update->counts.refused_f1;
    return;
  }
  if (HasMemberIn(members, frame->index)) {
    ++update->counts.duplicates;
  } else {
    update->tracks[feature] = track;
    ++update->counts.extended;
  }
  frame->tracks[feature] = track;
  members.push_back(member);
}

void TrackBuilder::Link(TrackId a, TrackId b, FrameTable* frame, TrackUpdate* update) {
  if (!PassesFilterF1(members_[a], members_[b], options_.same_feature_px)) {
    ++update->counts.refused_f1;
    return;
  }
  const auto [kept, gone] = std::minmax(a, b);
  update->links.emplace_back(kept, gone);
  ++update->counts.linked;
  Unite(kept, gone, frame);
}

void TrackBuilder::Unite(TrackId kept, TrackId gone, FrameTable* frame) {
  for (const TrackMember& member : members_[gone]) {
    FrameTable* table = member.frame == frame->index ? frame : FindFrame(member.frame);
    table->tracks[member.feature] = kept;
  }
  members_[kept] = MergeMembers(members_[kept], members_[gone]);
  members_.erase(gone);
}

void TrackBuilder::BeginTracks(FrameTable* frame, TrackUpdate* update) {
  for (uint32_t feature = 0; feature < frame->tracks.size(); ++feature) {
    if (frame->tracks[feature] != 0) continue;
    const TrackId track = next_track_++;
    frame->tracks[feature] = track;
    update->tracks[feature] = track;
    members_[track] = {{frame->index, feature, frame->keypoints_px[feature]}};
    ++update->counts.new_tracks;
  }
}

void TrackBuilder::ForgetOldFrames() {
  while (frames_.size() > static_cast<size_t>(options_.remembered_frames)) {
    const FrameTable& oldest = frames_.front();
    for (const TrackId track : oldest.tracks) {
      const auto it = members_.find(track);
      if (it == members_.end()) continue;
      std::vector<TrackMember>& members = it->second;
      members.erase(
          std::remove_if(members.begin(), members.end(),
                         [&oldest](const TrackMember& m) { return m.frame == oldest.index; }),
          members.end());
      if (members.empty()) members_.erase(it);
    }
    frames_.pop_front();
  }
}

}  // namespace rovio_sfm
