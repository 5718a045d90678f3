#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/sim3.h"

namespace rovio_sfm {

// A camera, or anything with a gauge of its own.
struct PoseGraphNode {
  Sim3 node_from_map;
  bool fixed = false;
};

// A measured similarity between two nodes.
struct PoseGraphEdge {
  uint32_t a = 0, b = 0;  // into PoseGraph::nodes
  Sim3 b_from_a;
  // 1 sigma, above 0; lengths of node b.
  double sigma_rotation_rad = 0.01, sigma_translation = 0.01, sigma_log_scale = 0.01;
  bool switchable = false;  // may be false: loops and merges
};

struct PoseGraph {
  std::vector<PoseGraphNode> nodes;
  std::vector<PoseGraphEdge> edges;
};

struct PoseGraphReport {
  bool usable = false;                          // false: nothing was changed
  int iterations = 0;                           // of all solutions
  double initial_cost = 0.0, final_cost = 0.0;  // half the squared sigmas, without what is left out
  std::vector<uint32_t> switched_off;           // edges, ascending
  std::string message;                          // why it is not usable
};

// How far an edge is from the nodes' places, in sigmas.
double EdgeErrorSigmas(const PoseGraph& graph, const PoseGraphEdge& edge);

// Moves the free nodes so that the edges fit best, over rotation, translation and scale (Strasdat
// 2010). Switchable edges weigh less the worse they fit (Suenderhauf 2012), at first hardly so,
// that true ones survive a large drift; the worst are left out in the end. Without a fixed node the
// first one holds the gauge. One thread: the same bytes every time.
PoseGraphReport OptimizePoseGraph(PoseGraph* graph);

}  // namespace rovio_sfm
