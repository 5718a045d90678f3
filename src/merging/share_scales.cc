#include "rovio_sfm/merging/share_scales.h"

#include <cmath>
#include <map>
#include <set>
#include <string>

namespace rovio_sfm {
namespace {

// Sums over the sessions of one map.
struct ScaleSum {
  double weight = 0.0;
  double weighted_log = 0.0;  // of metres per map unit
  std::set<std::string> sources;
};

std::string Join(const std::set<std::string>& names) {
  std::string joined;
  for (const std::string& name : names) joined += (joined.empty() ? "" : ", ") + name;
  return joined;
}

}  // namespace

void ShareScales(std::vector<SessionSnapshot>* sessions) {
  std::map<MapId, ScaleSum> sums;
  std::map<MapId, size_t> num_sessions;
  for (const SessionSnapshot& session : *sessions) {
    ++num_sessions[session.map];
    if (!session.scale) continue;
    const double weight = 1.0 / (session.scale->sigma_log * session.scale->sigma_log);
    ScaleSum& sum = sums[session.map];
    sum.weight += weight;
    sum.weighted_log +=
        weight * std::log(session.scale->metres_per_unit / session.map_from_session.scale);
    sum.sources.insert(session.scale->source);
  }
  for (SessionSnapshot& session : *sessions) {
    const auto sum = sums.find(session.map);
    if (sum == sums.end() || num_sessions[session.map] == 1) continue;
    const double metres_per_map_unit = std::exp(sum->second.weighted_log / sum->second.weight);
    session.scale = MapScale{metres_per_map_unit * session.map_from_session.scale,
                             1.0 / std::sqrt(sum->second.weight), Join(sum->second.sources)};
  }
}

double ScaleDisagreement(const std::optional<MapScale>& a, const std::optional<MapScale>& b,
                         const Sim3& b_from_a) {
  if (!a || !b) return 0.0;
  const double gap = std::log(b->metres_per_unit * b_from_a.scale / a->metres_per_unit);
  return std::abs(gap) / std::hypot(a->sigma_log, b->sigma_log);
}

}  // namespace rovio_sfm
