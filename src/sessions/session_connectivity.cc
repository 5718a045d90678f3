#include "rovio_sfm/sessions/session_connectivity.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "rovio_sfm/util/union_find.h"

namespace rovio_sfm {
namespace {

// Heaviest first; then by what the link says, never by where it stands in the list.
auto SortKey(const SessionLink& link) {
  const Eigen::Quaterniond& q = link.b_from_a.rotation;
  const Eigen::Vector3d& t = link.b_from_a.translation;
  return std::make_tuple(-link.weight, std::min(link.a, link.b), std::max(link.a, link.b), link.a,
                         link.b_from_a.scale, q.w(), q.x(), q.y(), q.z(), t.x(), t.y(), t.z());
}

// Kruskal: the links of the heaviest forest.
std::set<size_t> ChooseTree(const std::vector<SessionLink>& links) {
  std::vector<size_t> order(links.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::sort(order.begin(), order.end(),
            [&](size_t x, size_t y) { return SortKey(links[x]) < SortKey(links[y]); });
  UnionFind<SessionId> joined;
  std::set<size_t> tree;
  for (const size_t i : order) {
    if (joined.Find(links[i].a) == joined.Find(links[i].b)) continue;
    joined.Union(links[i].a, links[i].b);
    tree.insert(i);
  }
  return tree;
}

using Neighbours = std::map<SessionId, std::map<SessionId, Sim3>>;  // [a][b]: a_from_b

Neighbours NeighboursInTree(const std::vector<SessionLink>& links, const std::set<size_t>& tree) {
  Neighbours neighbours;
  for (const size_t i : tree) {
    neighbours[links[i].b][links[i].a] = links[i].b_from_a;
    neighbours[links[i].a][links[i].b] = Inverse(links[i].b_from_a);
  }
  return neighbours;
}

// All sessions that the tree reaches from the root.
std::map<SessionId, Sim3> WalkTree(SessionId root, const Neighbours& neighbours) {
  std::map<SessionId, Sim3> map_from_session{{root, Sim3{}}};
  std::deque<SessionId> open{root};
  for (; !open.empty(); open.pop_front()) {
    const auto it = neighbours.find(open.front());
    if (it == neighbours.end()) continue;
    for (const auto& [session, here_from_session] : it->second) {
      const Sim3 placed = map_from_session.at(open.front()) * here_from_session;
      if (map_from_session.emplace(session, placed).second) open.push_back(session);
    }
  }
  return map_from_session;
}

CycleGap MeasureGap(size_t index, const SessionLink& link,
                    const std::map<SessionId, Sim3>& map_from_session) {
  const Sim3 a_from_b = Inverse(map_from_session.at(link.a)) * map_from_session.at(link.b);
  const Sim3 a_from_a = a_from_b * link.b_from_a;
  return {index, a_from_a, RotationAngle(a_from_a.rotation), std::log(a_from_a.scale),
          a_from_a.translation.norm()};
}

std::set<SessionId> AllSessions(const std::vector<SessionId>& sessions,
                                const std::vector<SessionLink>& links) {
  std::set<SessionId> all(sessions.begin(), sessions.end());
  for (const SessionLink& link : links) all.insert({link.a, link.b});
  return all;
}

}  // namespace

std::vector<ConnectedMap> ConnectSessions(const std::vector<SessionId>& sessions,
                                          const std::vector<SessionLink>& links) {
  const std::set<size_t> tree = ChooseTree(links);
  const Neighbours neighbours = NeighboursInTree(links, tree);
  std::set<SessionId> remaining = AllSessions(sessions, links);
  std::vector<ConnectedMap> maps;
  while (!remaining.empty()) {
    const SessionId root = *remaining.begin();
    const std::map<SessionId, Sim3> map_from_session = WalkTree(root, neighbours);
    ConnectedMap& map = maps.emplace_back();
    map.id = MapId{root.value};
    for (const auto& [session, placed] : map_from_session) {
      map.members.push_back({session, placed});
      remaining.erase(session);
    }
    for (size_t i = 0; i < links.size(); ++i) {
      if (tree.count(i) > 0 || map_from_session.count(links[i].a) == 0) continue;
      map.gaps.push_back(MeasureGap(i, links[i], map_from_session));
    }
  }
  return maps;
}

}  // namespace rovio_sfm
