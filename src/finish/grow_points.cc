#include "rovio_sfm/finish/grow_points.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "rovio_sfm/geometry/triangulate.h"

namespace rovio_sfm {
namespace {

constexpr size_t kNoPoint = SIZE_MAX;

PointView SeenFrom(const MapModel& model, const ModelView& view, const FeatureNoise& noise) {
  const ModelImage& image = model.images[view.image];
  const Keypoint& keypoint = image.keypoints[view.keypoint];
  return {image.cam_from_map, keypoint.x_normalized,
          SigmaOf(keypoint, model.cameras[image.camera].MeanFocal(), noise)};
}

double ErrorSigmas(const MapModel& model, const ModelView& view, const Eigen::Vector3d& x_in_map,
                   const FeatureNoise& noise) {
  const PointView seen = SeenFrom(model, view, noise);
  const auto error = ReprojectionError(seen.cam_from_map, seen.x_normalized, x_in_map);
  return error ? *error / seen.sigma : HUGE_VAL;
}

bool IsBefore(const ModelView& a, const ModelView& b) { return a.image < b.image; }

bool SeesFrom(const ModelPoint& point, uint32_t image) {
  return std::binary_search(point.views.begin(), point.views.end(), ModelView{image, 0}, IsBefore);
}

void AddView(const ModelView& view, ModelPoint* point) {
  point->views.insert(std::upper_bound(point->views.begin(), point->views.end(), view, IsBefore),
                      view);
}

// The point of each feature, by image.
std::vector<std::vector<size_t>> PointOfFeature(const MapModel& model) {
  std::vector<std::vector<size_t>> point_of;
  for (const ModelImage& image : model.images) {
    point_of.emplace_back(image.keypoints.size(), kNoPoint);
  }
  for (size_t i = 0; i < model.points.size(); ++i) {
    for (const ModelView& view : model.points[i].views) point_of[view.image][view.keypoint] = i;
  }
  return point_of;
}

// The one of the points that a feature fits best; nothing where it fits none.
std::optional<size_t> BestOwner(const MapModel& model, const std::set<size_t>& owners,
                                const ModelView& view, const GrowOptions& options) {
  std::optional<size_t> best;
  double least = options.triangulate.max_error_sigmas;
  for (const size_t owner : owners) {
    const ModelPoint& point = model.points[owner];
    if (SeesFrom(point, view.image)) continue;
    const double error = ErrorSigmas(model, view, point.x_in_map, options.noise);
    if (error <= least) best = owner, least = error;
  }
  return best;
}

// One view an image: the first.
std::vector<ModelView> OneByImage(const std::vector<ModelView>& views) {
  std::vector<ModelView> unique;
  for (const ModelView& view : views) {
    if (unique.empty() || unique.back().image != view.image) unique.push_back(view);
  }
  return unique;
}

// Makes a point of the views that agree and takes those out; false where there is none.
bool TakePoint(const GrowOptions& options, std::vector<ModelView>* views, MapModel* model) {
  if (views->size() < options.min_views) return false;
  std::vector<PointView> seen;
  for (const ModelView& view : *views) seen.push_back(SeenFrom(*model, view, options.noise));
  const auto found = TriangulatePoint(seen, options.triangulate);
  if (!found || found->inliers.size() < options.min_views) return false;
  ModelPoint point;
  point.x_in_map = found->position;
  std::vector<ModelView> left;
  for (uint32_t i = 0; i < views->size(); ++i) {
    const bool agrees = std::binary_search(found->inliers.begin(), found->inliers.end(), i);
    (agrees ? point.views : left).push_back((*views)[i]);
  }
  model->points.push_back(std::move(point));
  *views = std::move(left);
  return true;
}

// The points that a drive saw first as a problem with fixed cameras.
struct DrivePart {
  BundleProblem problem;
  std::vector<size_t> points;  // of problem.points
};

void AddToPart(const MapModel& model, size_t index, const FeatureNoise& noise, DrivePart* part) {
  const ModelPoint& point = model.points[index];
  const auto number = static_cast<uint32_t>(part->points.size());
  part->points.push_back(index);
  part->problem.points.push_back(point.x_in_map);
  for (const ModelView& view : point.views) {
    const PointView seen = SeenFrom(model, view, noise);
    if (!((seen.cam_from_map * point.x_in_map).z() > 0.0)) continue;
    part->problem.observations.push_back({view.image, number, seen.sigma, seen.x_normalized});
  }
}

std::vector<DrivePart> PartsOf(const MapModel& model, const FeatureNoise& noise) {
  std::vector<BundleCamera> cameras;
  for (const ModelImage& image : model.images) cameras.push_back({image.cam_from_map, true});
  std::map<DriveId, DrivePart> by_drive;
  for (size_t i = 0; i < model.points.size(); ++i) {
    const DriveId& drive = model.images[model.points[i].views.front().image].id.drive;
    AddToPart(model, i, noise, &by_drive[drive]);
  }
  std::vector<DrivePart> parts;
  for (auto& [drive, part] : by_drive) {
    part.problem.cameras = cameras;
    parts.push_back(std::move(part));
  }
  return parts;
}

double Parallax(const MapModel& model, const ModelPoint& point) {
  double widest = 0.0;
  for (size_t b = 1; b < point.views.size(); ++b) {
    for (size_t a = 0; a < b; ++a) {
      widest =
          std::max(widest, ParallaxAngle(OriginInA(model.images[point.views[a].image].cam_from_map),
                                         OriginInA(model.images[point.views[b].image].cam_from_map),
                                         point.x_in_map));
    }
  }
  return widest;
}

// Without its bad views.
ModelPoint WithoutBadViews(const MapModel& model, ModelPoint point, const GrowOptions& options) {
  const auto is_bad = [&](const ModelView& view) {
    return !(ErrorSigmas(model, view, point.x_in_map, options.noise) <= options.max_error_sigmas);
  };
  point.views.erase(std::remove_if(point.views.begin(), point.views.end(), is_bad),
                    point.views.end());
  return point;
}

}  // namespace

size_t AddPoints(const std::vector<std::vector<ModelView>>& tracks, const GrowOptions& options,
                 MapModel* model) {
  const std::vector<std::vector<size_t>> point_of = PointOfFeature(*model);
  size_t num_barren = 0;
  for (const std::vector<ModelView>& track : tracks) {
    std::set<size_t> owners;
    for (const ModelView& view : track) owners.insert(point_of[view.image][view.keypoint]);
    const bool has_free = owners.erase(kNoPoint) > 0;
    if (!has_free) continue;
    std::vector<ModelView> left;
    for (const ModelView& view : track) {
      if (point_of[view.image][view.keypoint] != kNoPoint) continue;
      const auto owner = BestOwner(*model, owners, view, options);
      if (owner) {
        AddView(view, &model->points[*owner]);
      } else {
        left.push_back(view);
      }
    }
    left = OneByImage(left);
    size_t num_taken = 0;
    while (TakePoint(options, &left, model)) ++num_taken;
    if (owners.empty() && num_taken == 0) ++num_barren;
  }
  return num_barren;
}

size_t AdjustPoints(size_t num_kept, const GrowOptions& options, MapModel* model) {
  const std::vector<ModelPoint> before(model->points.begin(),
                                       model->points.begin() + static_cast<ptrdiff_t>(num_kept));
  for (DrivePart& part : PartsOf(*model, options.noise)) {
    if (!AdjustBundle(&part.problem, options.adjust).usable) continue;
    for (size_t i = 0; i < part.points.size(); ++i) {
      model->points[part.points[i]].x_in_map = part.problem.points[i];
    }
  }
  std::vector<ModelPoint> kept;
  for (size_t i = 0; i < model->points.size(); ++i) {
    const ModelPoint point = WithoutBadViews(*model, model->points[i], options);
    if (i < num_kept) {
      kept.push_back(point.views.size() < 2 ? before[i] : point);
    } else if (point.views.size() >= options.min_views &&
               Parallax(*model, point) >= options.triangulate.min_parallax_rad) {
      kept.push_back(point);
    }
  }
  const size_t num_removed = model->points.size() - kept.size();
  model->points = std::move(kept);
  return num_removed;
}

}  // namespace rovio_sfm
