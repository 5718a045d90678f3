#include "rovio_sfm/merging/spread_gap.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "rovio_sfm/sessions/pose_graph.h"
#include "rovio_sfm/sfm/session_bundle.h"

namespace rovio_sfm {
namespace {

constexpr size_t kNeighbours = 4;           // keyframes after each that are tied to it
constexpr size_t kMinSharedLinks = 15;      // links that tie two frames
constexpr double kSigmaRotation = 0.002;    // rad, of a step between neighbours
constexpr double kSigmaTranslation = 0.01;  // of a step, as a share of its length
constexpr double kSigmaLogScale = 0.003;    // of a step: what drifts most in a monocular map
constexpr double kLoopSigma = 0.5;          // of the loop, in sigmas of a step: it is seen at once

Sim3 ToSim3(const Rigid3& rigid) { return {1.0, rigid.rotation, rigid.translation}; }

// Nodes and edges, and which keyframe each node stands for.
class GraphBuilder {
 public:
  explicit GraphBuilder(const std::vector<PlacedSession>& sessions) : sessions_(sessions) {
    for (size_t i = 0; i < sessions_.size(); ++i) AddSession(i);
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

  PoseGraph& graph() { return graph_; }

  std::optional<uint32_t> FindNode(SessionId session, uint32_t frame) const {
    const auto it = nodes_.find({session, frame});
    return it == nodes_.end() ? std::nullopt : std::optional<uint32_t>(it->second);
  }

 private:
  const PlacedSession& PlacedOf(SessionId id) const {
    return *std::find_if(sessions_.begin(), sessions_.end(),
                         [&](const PlacedSession& placed) { return placed.session->id() == id; });
  }

  void AddSession(size_t number) {
    const PlacedSession& placed = sessions_[number];
    std::vector<uint32_t> recent;
    for (const auto& [index, frame] : placed.session->keyframes()) {
      if (frame.weak) continue;
      const auto node = static_cast<uint32_t>(graph_.nodes.size());
      graph_.nodes.push_back({ToSim3(CamFromMap(placed, index)), node == 0});
      nodes_[{placed.session->id(), index}] = node;
      for (size_t i = 0; i < recent.size(); ++i) {
        const auto steps = static_cast<double>(recent.size() - i);  // drift grows with them
        AddEdge(recent[i], node, std::nullopt, steps, false);
      }
      recent.push_back(node);
      if (recent.size() > kNeighbours) recent.erase(recent.begin());
    }
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
  std::map<std::pair<SessionId, uint32_t>, uint32_t> nodes_;
  PoseGraph graph_;
};

// A camera without scale at the centre and with the rotation of the node.
Rigid3 CameraOf(const Sim3& node_from_map) {
  const Eigen::Vector3d centre = Inverse(node_from_map).translation;
  return {node_from_map.rotation, -(node_from_map.rotation * centre)};
}

// Writes the nodes into a session; landmarks move with the first frame that sees them.
void Apply(const GraphBuilder& builder, const PoseGraph& solved, const PlacedSession& placed) {
  const Sim3 session_from_map = Inverse(placed.map_from_session);
  SessionBundle bundle = MakeGlobalBundle(*placed.session);
  std::map<uint32_t, Sim3> new_from_old;  // of the session, by frame
  for (size_t i = 0; i < bundle.frames.size(); ++i) {
    const uint32_t frame = bundle.frames[i];
    const Sim3& node_from_map =
        solved.nodes[*builder.FindNode(placed.session->id(), frame)].node_from_map;
    const Sim3 old_from_session = ToSim3(CamFromMap(placed, frame)) * placed.map_from_session;
    new_from_old[frame] = session_from_map * Inverse(node_from_map) * old_from_session;
    bundle.problem.cameras[i].cam_from_map =
        TransformCamera(session_from_map, CameraOf(node_from_map));
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
