#include "rovio_sfm/surface/reconstruct_surface.h"

#include <pcl/filters/radius_outlier_removal.h>
#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface/mls.h>
#include <pcl/surface/poisson.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <map>

#include "rovio_sfm/surface/drop_chatter.h"
#include "rovio_sfm/util/median.h"

namespace rovio_sfm {
namespace {

using Point = pcl::PointXYZRGBNormal;
using Cloud = pcl::PointCloud<Point>;

constexpr size_t kMinPoints = 100;

Cloud::Ptr ToPcl(const PointCloud& cloud) {
  auto points = pcl::make_shared<Cloud>();
  for (const DensePoint& from : cloud) {
    Point to;
    to.getVector3fMap() = from.position;
    to.getNormalVector3fMap() = from.normal;
    to.r = from.color[0], to.g = from.color[1], to.b = from.color[2];
    points->push_back(to);
  }
  return points;
}

// The median distance of a point to its nearest neighbour.
double SpacingOf(const Cloud::Ptr& cloud) {
  pcl::KdTreeFLANN<Point> tree;
  tree.setInputCloud(cloud);
  std::vector<double> distances;
  pcl::Indices indices(2);
  std::vector<float> squared(2);
  for (const Point& point : *cloud) {
    if (tree.nearestKSearch(point, 2, indices, squared) == 2) {
      distances.push_back(std::sqrt(squared[1]));
    }
  }
  return Median(std::move(distances));
}

Cloud::Ptr RemoveOutliers(const Cloud::Ptr& cloud, double spacing, const SurfaceOptions& options) {
  auto dense = pcl::make_shared<Cloud>();
  pcl::RadiusOutlierRemoval<Point> by_radius;
  by_radius.setInputCloud(cloud);
  by_radius.setRadiusSearch(options.radius_spacings * spacing);
  by_radius.setMinNeighborsInRadius(options.min_in_radius);
  by_radius.filter(*dense);
  auto kept = pcl::make_shared<Cloud>();
  pcl::StatisticalOutlierRemoval<Point> by_neighbors;
  by_neighbors.setInputCloud(dense);
  by_neighbors.setMeanK(options.outlier_neighbors);
  by_neighbors.setStddevMulThresh(options.outlier_sigmas);
  by_neighbors.filter(*kept);
  return kept;
}

// Positions on the local surface, with its normal; turned to the side that the point's own has.
Cloud::Ptr Smooth(const Cloud::Ptr& cloud, double radius) {
  pcl::MovingLeastSquares<Point, Point> mls;
  mls.setComputeNormals(true);
  mls.setInputCloud(cloud);
  mls.setPolynomialOrder(1);
  mls.setSearchMethod(pcl::make_shared<pcl::search::KdTree<Point>>());
  mls.setSearchRadius(radius);
  auto smooth = pcl::make_shared<Cloud>();
  mls.process(*smooth);
  const auto sources = mls.getCorrespondingIndices();
  for (size_t i = 0; i < smooth->size(); ++i) {
    const Point& source = (*cloud)[static_cast<size_t>(sources->indices[i])];
    Point& point = (*smooth)[i];
    point.rgb = source.rgb;
    if (point.getNormalVector3fMap().dot(source.getNormalVector3fMap()) < 0.0f) {
      point.getNormalVector3fMap() *= -1.0f;
    }
  }
  return smooth;
}

// What Poisson cannot use: normals that are unknown.
Cloud::Ptr WithNormals(const Cloud::Ptr& cloud) {
  auto kept = pcl::make_shared<Cloud>();
  for (const Point& point : *cloud) {
    const float norm = point.getNormalVector3fMap().norm();
    if (std::isfinite(norm) && norm > 0.5f) kept->push_back(point);
  }
  return kept;
}

using Triangles = std::vector<std::array<uint32_t, 3>>;

// Corners near a point keep that point's colour; triangles with any other corner go.
TriangleMesh Trim(const Cloud& corners, const Triangles& triangles, const Cloud::Ptr& cloud,
                  double max_distance) {
  pcl::KdTreeFLANN<Point> tree;
  tree.setInputCloud(cloud);
  pcl::Indices nearest(1);
  std::vector<float> squared(1);
  TriangleMesh mesh;
  std::vector<uint32_t> index_of(corners.size(), UINT32_MAX);
  for (size_t i = 0; i < corners.size(); ++i) {
    if (tree.nearestKSearch(corners[i], 1, nearest, squared) != 1) continue;
    if (squared[0] > max_distance * max_distance) continue;
    const Point& point = (*cloud)[static_cast<size_t>(nearest[0])];
    index_of[i] = static_cast<uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back({corners[i].getVector3fMap(),
                             point.getNormalVector3fMap(),
                             {point.r, point.g, point.b},
                             0});
  }
  for (const auto& triangle : triangles) {
    const std::array<uint32_t, 3> kept = {index_of[triangle[0]], index_of[triangle[1]],
                                          index_of[triangle[2]]};
    if (std::count(kept.begin(), kept.end(), UINT32_MAX) == 0) mesh.triangles.push_back(kept);
  }
  return mesh;
}

// Parts that hang together by common corners, small ones dropped, corners without triangles too.
TriangleMesh DropSpecks(const TriangleMesh& mesh, size_t min_part) {
  boost::disjoint_sets_with_storage<> parts(mesh.vertices.size());
  for (const auto& triangle : mesh.triangles) {
    parts.union_set(triangle[0], triangle[1]);
    parts.union_set(triangle[0], triangle[2]);
  }
  std::map<size_t, size_t> size_of;
  for (const auto& triangle : mesh.triangles) ++size_of[parts.find_set(triangle[0])];
  TriangleMesh kept;
  std::vector<uint32_t> index_of(mesh.vertices.size(), UINT32_MAX);
  for (std::array<uint32_t, 3> triangle : mesh.triangles) {
    if (size_of[parts.find_set(triangle[0])] < min_part) continue;
    for (uint32_t& corner : triangle) {
      uint32_t& index = index_of[corner];
      if (index == UINT32_MAX) {
        index = static_cast<uint32_t>(kept.vertices.size());
        kept.vertices.push_back(mesh.vertices[corner]);
      }
      corner = index;
    }
    kept.triangles.push_back(triangle);
  }
  return kept;
}

Triangles Poisson(const Cloud::Ptr& cloud, int depth, Cloud* corners) {
  pcl::Poisson<Point> poisson;
  poisson.setDepth(depth);
  poisson.setThreads(1);  // the same bytes on every machine
  poisson.setInputCloud(cloud);
  std::vector<pcl::Vertices> polygons;
  const DropChatter quiet;
  poisson.reconstruct(*corners, polygons);
  Triangles triangles;
  for (const pcl::Vertices& polygon : polygons) {
    triangles.push_back({static_cast<uint32_t>(polygon.vertices[0]),
                         static_cast<uint32_t>(polygon.vertices[1]),
                         static_cast<uint32_t>(polygon.vertices[2])});
  }
  return triangles;
}

}  // namespace

TriangleMesh ReconstructSurface(const PointCloud& cloud, const SurfaceOptions& options,
                                const SurfaceProgress& progress) {
  if (cloud.size() < kMinPoints) return {};
  size_t num_done = 0;
  const auto goes_on = [&] { return !progress || progress(++num_done, kSurfaceSteps); };
  const Cloud::Ptr points = ToPcl(cloud);
  const double spacing = SpacingOf(points);
  const Cloud::Ptr clean = RemoveOutliers(points, spacing, options);
  if (clean->size() < kMinPoints || !goes_on()) return {};
  const Cloud::Ptr smooth = WithNormals(Smooth(clean, options.smoothing_spacings * spacing));
  if (smooth->size() < kMinPoints || !goes_on()) return {};
  Cloud corners;
  const Triangles triangles = Poisson(smooth, options.poisson_depth, &corners);
  if (!goes_on()) return {};
  const TriangleMesh mesh = DropSpecks(
      Trim(corners, triangles, smooth, options.trim_spacings * spacing), options.min_part);
  return goes_on() ? mesh : TriangleMesh();
}

}  // namespace rovio_sfm
