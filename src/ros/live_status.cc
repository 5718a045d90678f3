#include "rovio_sfm/ros/live_status.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "rovio_sfm/scene/merge_report.h"
#include "rovio_sfm/util/count_text.h"

namespace rovio_sfm {
namespace {

using Json = nlohmann::ordered_json;

double Short(double value) { return std::round(value * 1e4) / 1e4; }

std::string NameOf(const FrameIdMsg& frame) {
  if (frame.drive.robot.empty()) return "by hand";
  return frame.drive.robot + "/" + std::to_string(frame.index);
}

const char* StateName(uint8_t state) {
  static constexpr std::array<const char*, 4> kNames = {"begins", "maps", "finished", "lost"};
  return state < kNames.size() ? kNames[state] : "unknown";
}

Json SessionJson(const SessionSummary& session) {
  return {{"session", session.session},      {"map", session.map},
          {"robot", session.drive.robot},    {"state", StateName(session.state)},
          {"images", session.num_frames},    {"keyframes", session.num_keyframes},
          {"weak", session.num_weak_frames}, {"first", session.first_index},
          {"last", session.last_index}};
}

Json MergeJson(const MergeReportMsg& merge) {
  return {{"id", merge.id},
          {"kind", ToString(static_cast<MergeKind>(merge.kind))},
          {"verdict", ToString(static_cast<MergeVerdict>(merge.verdict))},
          {"accepted_by", ToString(static_cast<AcceptedBy>(merge.accepted_by))},
          {"reason", merge.reason},
          {"warning", merge.warning},
          {"query", NameOf(merge.query)},
          {"other", NameOf(merge.other)},
          {"sessions", {merge.query_session, merge.other_session}},
          {"inliers", merge.num_inliers},
          {"links", merge.num_links},
          {"scale", Short(merge.scale)}};
}

// As mapping chooses the map that `cloud` shows: that of the first session with frames.
const MapSummary* FindRootMap(const MapStatus& status) {
  const auto first = std::find_if(status.sessions.begin(), status.sessions.end(),
                                  [](const SessionSummary& s) { return s.num_frames > 0; });
  if (first == status.sessions.end()) return nullptr;
  const auto root = std::find_if(status.maps.begin(), status.maps.end(),
                                 [&](const MapSummary& map) { return map.map == first->map; });
  return root == status.maps.end() ? nullptr : &*root;
}

Json FiguresJson(const MapStatus& status, const MapSummary& map) {
  uint32_t num_keyframes = 0;
  for (const SessionSummary& session : status.sessions) {
    if (session.map == map.map) num_keyframes += session.num_keyframes;
  }
  Json figures = {{"images", map.num_frames},
                  {"keyframes", num_keyframes},
                  {"sessions", map.sessions.size()},
                  {"landmarks", map.num_landmarks},
                  {"projections", map.num_observations},
                  {"mean error, px", Short(map.mean_error_px)}};
  if (map.metric) {
    figures["scale from"] = map.scale_source;
    figures["scale, 1 sigma, %"] = Short(100.0 * map.scale_sigma_log);
  }
  figures["maps"] = std::count_if(status.maps.begin(), status.maps.end(),
                                  [](const MapSummary& other) { return other.num_frames > 0; });
  figures["merges accepted"] = status.num_merges_accepted;
  figures["merges provisional"] = status.num_merges_provisional;
  figures["merges refused"] = status.num_merges_refused;
  if (status.num_localized + status.num_not_localized > 0) {
    figures["images localized"] = status.num_localized;
    figures["images not localized"] = status.num_not_localized;
  }
  return figures;
}

Json WarningsJson(const MapStatus& status) {
  Json warnings = status.why_not_metric;
  if (!status.store_error.empty()) warnings.push_back("Maps are not saved: " + status.store_error);
  const auto tell = [&](uint32_t count, const std::string& what) {
    if (count > 0) warnings.push_back(what);
  };
  tell(status.num_refused, CountWere(status.num_refused, "frame event") + " malformed");
  tell(status.num_missing, CountText(status.num_missing, "frame") + " never arrived");
  tell(status.num_dropped,
       CountWere(status.num_dropped, "frame event") + " dropped because a queue was full");
  tell(status.num_gaps_lost,
       CountText(status.num_gaps_lost, "gap") + " in drives not answered for in time");
  return warnings;
}

}  // namespace

std::string LiveStatus(const MapStatus& status) {
  const MapSummary* root = FindRootMap(status);
  Json sessions = Json::array(), merges = Json::array();
  for (const SessionSummary& session : status.sessions) sessions.push_back(SessionJson(session));
  for (const MergeReportMsg& merge : status.merges) merges.push_back(MergeJson(merge));
  const Json json = {{"root", root == nullptr ? 0u : root->map},
                     {"unit", root != nullptr && root->metric ? "metres" : "map units"},
                     {"figures", root == nullptr ? Json::object() : FiguresJson(status, *root)},
                     {"warnings", WarningsJson(status)},
                     {"sessions", sessions},
                     {"merges", merges}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace rovio_sfm
