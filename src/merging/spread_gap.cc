#include "rovio_sfm/merging/spread_gap.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "rovio_sfm/merging/adjust_map.h"
#include "rovio_sfm/sessions/pose_graph.h"
#include "rovio_sfm/sfm/session_bundle.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMaxNodes = 150;           // a long way is bent at as many places
constexpr size_t kNeighbours = 4;           // nodes after each that are tied to it
constexpr size_t kMinSharedLinks = 15;      // links that tie two frames
constexpr double kSigmaRotation = 0.002;    // rad, of a step between keyframes
constexpr double kSigmaTranslation = 0.01;  // of a step, as a share of its length
constexpr double kSigmaLogScale = 0.003;    // of a step: what drifts most in a monocular map
constexpr double kLoopSigma = 0.5;          // of the loop, in sigmas of a step: it is seen at once

Sim3 ToSim3(const Rigid3& rigid) { return {1.0, rigid.rotation, rigid.translation}; }

// Nodes and edges, and which keyframes each node stands for: itself and those after it, up to the
// next one's.
class GraphBuilder {
 public:
  explicit GraphBuilder(const std::vector<PlacedSession>& sessions)
      : sessions_(sessions), stride_((NumFrames(sessions) + kMaxNodes - 1) / kMaxNodes) {
    for (const PlacedSession& placed : sessions_) AddSession(placed);
  }

  void AddLoop(const MergeReport& loop) {
    const auto a = FindNode(loop.other_session, loop.other.index);
    const auto b = FindNode(loop.query_session, loop.query.index);
    if (!a || !b || *a == *b) return;
    const PlacedSession &in_a = PlacedOf(loop.other_session), &in_b = PlacedOf(loop.query_session);
    const Sim3 other_from_a = graph_.nodes[*a].node_from_map * in_a.map_from_session;
    const Sim3 query_from_b = graph_.nodes[*b].node_from_map * in_b.map_from_session;
    AddEdge(*a, *b, query_from_b * loop.query_from_other * Inverse(other_from_a), kLoopSigma, true);
  }

  // Frames that accepted links join keep their relative pose.
  void AddLinks(const std::vector<FeatureLink>& links) {
    std::map<std::pair<uint32_t, uint32_t>, size_t> shared;
    for (const FeatureLink& link : links) {
      const auto a = FindNode(link.a.session, link.a.frame);
      const auto b = FindNode(link.b.session, link.b.frame);
      if (a && b && *a != *b) ++shared[{std::min(*a, *b), std::max(*a, *b)}];
    }
    for (const auto& [pair, count] : shared) {
      if (count >= kMinSharedLinks) AddEdge(pair.first, pair.second, std::nullopt, 1.0, false);
    }
  }

  const PoseGraph& graph() const { return graph_; }

  // That which stands for the frame.
  std::optional<uint32_t> FindNode(SessionId session, uint32_t frame) const {
    const auto it = nodes_.find({session, frame});
    return it == nodes_.end() ? std::nullopt : std::optional<uint32_t>(it->second);
  }

 private:
  const PlacedSession& PlacedOf(SessionId id) const {
    return *std::find_if(sessions_.begin(), sessions_.end(),
                         [&](const PlacedSession& placed) { return placed.session->id() == id; });
  }

  void AddSession(const PlacedSession& placed) {
    std::vector<uint32_t> recent;
    size_t number = 0;
    for (const auto& [index, frame] : placed.session->keyframes()) {
      if (frame.weak) continue;
      if (number++ % stride_ == 0) AddNode(ToSim3(CamFromMap(placed, index)), &recent);
      nodes_[{placed.session->id(), index}] = recent.back();
    }
  }

  void AddNode(const Sim3& node_from_map, std::vector<uint32_t>* recent) {
    const auto node = static_cast<uint32_t>(graph_.nodes.size());
    graph_.nodes.push_back({node_from_map, node == 0});
    for (size_t i = 0; i < recent->size(); ++i) {
      const size_t steps = (recent->size() - i) * stride_;  // drift grows with them
      AddEdge((*recent)[i], node, std::nullopt, static_cast<double>(steps), false);
    }
    recent->push_back(node);
    if (recent->size() > kNeighbours) recent->erase(recent->begin());
  }

  // As measured, or as the nodes stand; sigma in those of one step.
  void AddEdge(uint32_t a, uint32_t b, const std::optional<Sim3>& measured, double sigma,
               bool switchable) {
    const Sim3 stands = graph_.nodes[b].node_from_map * Inverse(graph_.nodes[a].node_from_map);
    const double length = std::max(stands.translation.norm(), 1e-6);
    graph_.edges.push_back({a, b, measured.value_or(stands), sigma * kSigmaRotation,
                            sigma * kSigmaTranslation * length, sigma * kSigmaLogScale,
                            switchable});
  }

  const std::vector<PlacedSession>& sessions_;
  size_t stride_;  // keyframes from node to node
  std::map<std::pair<SessionId, uint32_t>, uint32_t> nodes_;
  PoseGraph graph_;
};

// How each frame of a session moves: as its node does.
std::map<uint32_t, Sim3> MovesOf(const GraphBuilder& builder, const PoseGraph& solved,
                                 const PlacedSession& placed, const std::vector<uint32_t>& frames) {
  std::map<uint32_t, Sim3> new_from_old;  // of the session
  for (const uint32_t frame : frames) {
    const uint32_t node = *builder.FindNode(placed.session->id(), frame);
    const Sim3 map_from_map =
        Inverse(solved.nodes[node].node_from_map) * builder.graph().nodes[node].node_from_map;
    new_from_old[frame] = Inverse(placed.map_from_session) * map_from_map * placed.map_from_session;
  }
  return new_from_old;
}

// Moves a session as its nodes moved; landmarks move with the first frame that sees them.
void Apply(const GraphBuilder& builder, const PoseGraph& solved, const PlacedSession& placed) {
  SessionBundle bundle = MakeGlobalBundle(*placed.session);
  const auto new_from_old = MovesOf(builder, solved, placed, bundle.frames);
  for (size_t i = 0; i < bundle.frames.size(); ++i) {
    Rigid3& pose = bundle.problem.cameras[i].cam_from_map;
    pose = TransformCamera(new_from_old.at(bundle.frames[i]), pose);
  }
  for (size_t i = 0; i < bundle.tracks.size(); ++i) {
    for (const Observation& view : placed.session->landmarks().at(bundle.tracks[i]).observations) {
      const auto moved = new_from_old.find(view.frame);
      if (moved == new_from_old.end()) continue;
      bundle.problem.points[i] = moved->second * bundle.problem.points[i];
      break;
    }
  }
  ApplyBundle(bundle, true, placed.session);
}

}  // namespace

bool SpreadGap(const std::vector<PlacedSession>& sessions, const MergeReport& loop,
               const std::vector<FeatureLink>& links) {
  GraphBuilder builder(sessions);
  builder.AddLinks(links);
  builder.AddLoop(loop);
  PoseGraph solved = builder.graph();
  const PoseGraphReport report = OptimizePoseGraph(&solved);
  if (!report.usable || !report.switched_off.empty()) return false;
  for (const PlacedSession& placed : sessions) Apply(builder, solved, placed);
  return true;
}

}  // namespace rovio_sfm
