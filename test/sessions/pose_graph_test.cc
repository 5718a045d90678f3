#include "rovio_sfm/sessions/pose_graph.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kNumNodes = 24;

// Cameras on a ring of radius 3, each with a gauge of its own: the scale grows along the ring.
Sim3 TrueNode(uint32_t i) {
  const double angle_rad = 2.0 * M_PI * i / kNumNodes;
  const Eigen::Quaterniond rotation(Eigen::AngleAxisd(-angle_rad, Eigen::Vector3d::UnitY()));
  const Eigen::Vector3d center(3.0 * std::sin(angle_rad), 0.0, 3.0 - 3.0 * std::cos(angle_rad));
  const double scale = std::exp(0.02 * i);
  return {scale, rotation, -scale * (rotation * center)};
}

PoseGraphEdge TrueEdge(uint32_t a, uint32_t b, bool switchable) {
  PoseGraphEdge edge;
  edge.a = a;
  edge.b = b;
  edge.b_from_a = TrueNode(b) * Inverse(TrueNode(a));
  edge.switchable = switchable;
  return edge;
}

// A small random similarity, 1 sigma per component.
Sim3 Noise(double sigma, Rng& rng) {
  const auto gaussians = [&] {
    const double x = rng.Gaussian(), y = rng.Gaussian(), z = rng.Gaussian();
    return Eigen::Vector3d(sigma * Eigen::Vector3d(x, y, z));
  };
  const Eigen::Vector3d turn = gaussians();
  return {std::exp(sigma * rng.Gaussian()),
          Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.stableNormalized())), gaussians()};
}

// The ring as its edges, but no loop edge, place it after drift; loops close it.
PoseGraph DriftedRing(double drift, bool edges_drift) {
  Rng rng(4);
  PoseGraph graph;
  graph.nodes.push_back({TrueNode(0), true});
  for (uint32_t i = 1; i < kNumNodes; ++i) {
    PoseGraphEdge edge = TrueEdge(i - 1, i, false);
    const Sim3 drifted = Noise(drift, rng) * edge.b_from_a;
    graph.nodes.push_back({drifted * graph.nodes[i - 1].node_from_map, false});
    if (edges_drift) edge.b_from_a = drifted;
    graph.edges.push_back(edge);
  }
  for (const uint32_t i : {kNumNodes - 1, kNumNodes - 2, kNumNodes - 3}) {
    graph.edges.push_back(TrueEdge(i, 0, true));
  }
  return graph;
}

double NodeDistance(const Sim3& node_from_map, const Sim3& truth) {
  const Eigen::Vector3d center = Inverse(node_from_map) * Eigen::Vector3d::Zero();
  const Eigen::Vector3d true_center = Inverse(truth) * Eigen::Vector3d::Zero();
  return (center - true_center).norm() +
         RotationAngle(node_from_map.rotation * truth.rotation.conjugate()) +
         std::abs(std::log(node_from_map.scale / truth.scale));
}

double WorstNode(const PoseGraph& graph) {
  double worst = 0.0;
  for (uint32_t i = 0; i < graph.nodes.size(); ++i) {
    worst = std::max(worst, NodeDistance(graph.nodes[i].node_from_map, TrueNode(i)));
  }
  return worst;
}

TEST(OptimizePoseGraph, RecoversARingWithDriftingScaleExactly) {
  PoseGraph graph = DriftedRing(0.05, false);
  EXPECT_GT(WorstNode(graph), 0.3);
  const PoseGraphReport report = OptimizePoseGraph(&graph);
  ASSERT_TRUE(report.usable) << report.message;
  EXPECT_LT(WorstNode(graph), 1e-5);
  EXPECT_TRUE(report.switched_off.empty());
  EXPECT_GT(report.initial_cost, 1.0);
  EXPECT_LT(report.final_cost, 1e-8);
}

TEST(OptimizePoseGraph, SpreadsTheDriftOfItsEdges) {
  PoseGraph graph = DriftedRing(0.01, true);
  const double before = WorstNode(graph);
  const PoseGraphReport report = OptimizePoseGraph(&graph);
  ASSERT_TRUE(report.usable) << report.message;
  EXPECT_LT(WorstNode(graph), 0.5 * before);
  EXPECT_TRUE(report.switched_off.empty());
  EXPECT_LT(report.final_cost, report.initial_cost);
}

TEST(OptimizePoseGraph, SwitchesAFalseLoopOff) {
  PoseGraph graph = DriftedRing(0.01, true);
  PoseGraph without = graph;
  graph.edges.push_back(TrueEdge(4, 16, true));
  graph.edges.back().b_from_a = Sim3{};  // as if both saw the same from one place
  const PoseGraphReport report = OptimizePoseGraph(&graph);
  ASSERT_TRUE(report.usable) << report.message;
  const auto last = static_cast<uint32_t>(graph.edges.size() - 1);
  EXPECT_EQ(report.switched_off, std::vector<uint32_t>{last});
  ASSERT_TRUE(OptimizePoseGraph(&without).usable);
  for (uint32_t i = 0; i < kNumNodes; ++i) {
    EXPECT_LT(NodeDistance(graph.nodes[i].node_from_map, without.nodes[i].node_from_map), 1e-3);
  }
}

TEST(OptimizePoseGraph, DoesNotDependOnTheGauge) {
  PoseGraph graph = DriftedRing(0.01, true), moved = graph;
  const Sim3 map_from_other{2.5, Eigen::Quaterniond(0.8, 0.2, -0.5, 0.1).normalized(), {1, -2, 3}};
  for (PoseGraphNode& node : moved.nodes) node.node_from_map = node.node_from_map * map_from_other;
  const PoseGraphReport one = OptimizePoseGraph(&graph);
  const PoseGraphReport two = OptimizePoseGraph(&moved);
  ASSERT_TRUE(one.usable && two.usable);
  EXPECT_NEAR(one.final_cost, two.final_cost, 1e-3 * one.final_cost);
  for (uint32_t i = 0; i < kNumNodes; ++i) {
    EXPECT_LT(NodeDistance(moved.nodes[i].node_from_map * Inverse(map_from_other),
                           graph.nodes[i].node_from_map),
              1e-3);
  }
}

TEST(OptimizePoseGraph, LeavesFixedNodesWhereTheyAre) {
  PoseGraph graph = DriftedRing(0.01, true);
  graph.nodes[10].fixed = true;
  const Sim3 before = graph.nodes[10].node_from_map;
  ASSERT_TRUE(OptimizePoseGraph(&graph).usable);
  EXPECT_EQ(graph.nodes[10].node_from_map.translation, before.translation);
  EXPECT_EQ(graph.nodes[10].node_from_map.scale, before.scale);
  EXPECT_EQ(graph.nodes[0].node_from_map.translation, TrueNode(0).translation);
}

TEST(OptimizePoseGraph, HoldsTheFirstNodeWhereNoneIsFixed) {
  PoseGraph graph = DriftedRing(0.05, false);
  graph.nodes[0].fixed = false;
  ASSERT_TRUE(OptimizePoseGraph(&graph).usable);
  EXPECT_LT(WorstNode(graph), 1e-5);
}

TEST(OptimizePoseGraph, GivesTheSameBytesTwice) {
  PoseGraph one = DriftedRing(0.02, true), two = one;
  OptimizePoseGraph(&one);
  OptimizePoseGraph(&two);
  for (uint32_t i = 0; i < kNumNodes; ++i) {
    EXPECT_EQ(one.nodes[i].node_from_map.translation, two.nodes[i].node_from_map.translation);
    EXPECT_EQ(one.nodes[i].node_from_map.scale, two.nodes[i].node_from_map.scale);
  }
}

TEST(OptimizePoseGraph, RefusesAGraphWithoutEdges) {
  PoseGraph graph;
  graph.nodes.push_back({TrueNode(3), false});
  const PoseGraphReport report = OptimizePoseGraph(&graph);
  EXPECT_FALSE(report.usable);
  EXPECT_EQ(report.message, "no edges");
}

TEST(EdgeErrorSigmas, CountsEachPartInItsSigma) {
  PoseGraph graph;
  graph.nodes = {{TrueNode(2), true}, {TrueNode(5), false}};
  PoseGraphEdge edge = TrueEdge(0, 1, false);
  edge.b_from_a = TrueNode(5) * Inverse(TrueNode(2));
  EXPECT_NEAR(EdgeErrorSigmas(graph, edge), 0.0, 1e-9);
  PoseGraphEdge off = edge;
  off.b_from_a.translation.x() += 0.03;
  EXPECT_NEAR(EdgeErrorSigmas(graph, off), 3.0, 1e-9);
  off = edge;
  off.b_from_a =
      Sim3{1.0, Eigen::Quaterniond(Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitZ())), {0, 0, 0}} *
      edge.b_from_a;
  EXPECT_NEAR(EdgeErrorSigmas(graph, off), 2.0, 1e-9);
  off = edge;
  off.b_from_a = Sim3{std::exp(0.04), Eigen::Quaterniond::Identity(), {0, 0, 0}} * edge.b_from_a;
  EXPECT_NEAR(EdgeErrorSigmas(graph, off), 4.0, 1e-9);
}

}  // namespace
}  // namespace rovio_sfm
