#include "rovio_sfm/ros/map_status_message.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/map_frames.h"
#include "rovio_sfm/ros/map_messages.h"
#include "rovio_sfm/ros/merge_report_message.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMaxReports = 50;

ros::Time NewestStamp(const MapSnapshot& snapshot) {
  int64_t newest_ns = 0;
  for (const SessionSnapshot& session : snapshot.sessions) {
    for (const auto& block : session.frames) {
      if (!block->empty()) newest_ns = std::max(newest_ns, block->back().stamp_ns);
    }
  }
  return ToTime(newest_ns);
}

uint32_t CountVerdict(const std::vector<MergeReport>& merges, MergeVerdict verdict) {
  return static_cast<uint32_t>(
      std::count_if(merges.begin(), merges.end(),
                    [&](const MergeReport& report) { return report.verdict == verdict; }));
}

void AddCounters(const MapPicture& picture, const IngestCounters& counters, MapStatus* status) {
  status->num_events = static_cast<uint32_t>(picture.num_events);
  status->num_refused = static_cast<uint32_t>(counters.refused + picture.counters.refused_events);
  status->num_missing = static_cast<uint32_t>(picture.counters.missing_events);
  status->num_dropped = static_cast<uint32_t>(counters.dropped);
  status->num_gaps_lost = static_cast<uint32_t>(counters.lost_gaps);
  status->num_place_matches = static_cast<uint32_t>(picture.num_place_matches);
  status->num_place_matches_waiting = static_cast<uint32_t>(picture.num_matches_waiting);
  status->num_place_matches_repeated = static_cast<uint32_t>(picture.num_matches_repeated);
  status->num_place_matches_refused = static_cast<uint32_t>(counters.refused_matches);
  status->num_place_matches_dropped = static_cast<uint32_t>(counters.dropped_matches);
}

void AddMerges(const std::vector<MergeReport>& merges, MapStatus* status) {
  status->num_merges_accepted = CountVerdict(merges, MergeVerdict::kAccepted);
  status->num_merges_provisional = CountVerdict(merges, MergeVerdict::kProvisional);
  status->num_merges_refused = CountVerdict(merges, MergeVerdict::kRefused);
  status->num_merges_undone = CountVerdict(merges, MergeVerdict::kUndone);
  const size_t first = merges.size() - std::min(merges.size(), kMaxReports);
  for (size_t i = first; i < merges.size(); ++i) status->merges.push_back(ToMessage(merges[i]));
}

}  // namespace

bool operator==(const IngestCounters& a, const IngestCounters& b) {
  const auto fields_of = [](const IngestCounters& c) {
    return std::tie(c.refused, c.dropped, c.lost_gaps, c.refused_matches, c.dropped_matches);
  };
  return fields_of(a) == fields_of(b);
}

std::optional<MapStatus> MapStatusWriter::Write(const MapPicture& picture,
                                                const IngestCounters& counters) {
  if (number_ == picture.number && counters_ == counters) return std::nullopt;
  number_ = picture.number;
  counters_ = counters;
  MapStatus status;
  status.header.frame_id = MapFrame();
  status.header.stamp = NewestStamp(*picture.snapshot);
  WriteSessions(picture, &status);
  WriteMaps(picture, &status);
  for (const FrameId& id : picture.saved_up_to) status.saved_up_to.push_back(ToMessage(id));
  status.num_localized = static_cast<uint32_t>(picture.num_localized);
  status.num_not_localized = static_cast<uint32_t>(picture.num_not_localized);
  status.store_error = picture.store_error;
  status.why_not_metric = WhyNotMetric(picture);
  AddCounters(picture, counters, &status);
  AddMerges(*picture.merges, &status);
  return status;
}

void MapStatusWriter::WriteSessions(const MapPicture& picture, MapStatus* status) {
  const auto last = std::exchange(sessions_, {});
  for (const SessionSnapshot& session : picture.snapshot->sessions) {
    const SessionStamp stamp = StampOf(picture, session);
    const auto before = last.find(session.id);
    const bool is_same = before != last.end() && before->second.stamp == stamp;
    const SessionSummary summary = is_same ? before->second.summary : SummaryOf(session);
    sessions_[session.id] = {stamp, summary};
    status->sessions.push_back(summary);
  }
}

void MapStatusWriter::WriteMaps(const MapPicture& picture, MapStatus* status) {
  const auto last = std::exchange(maps_, {});
  for (const auto& [id, stamp] : MapStamps(picture)) {
    const auto before = last.find(id);
    const bool is_same = before != last.end() && before->second.stamp == stamp;
    const auto summary = is_same ? before->second.summary : SummaryOf(*picture.snapshot, id);
    maps_[id] = {stamp, summary};
    if (summary) status->maps.push_back(*summary);
  }
}

}  // namespace rovio_sfm
