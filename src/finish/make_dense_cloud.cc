#include "rovio_sfm/finish/make_dense_cloud.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "rovio_sfm/util/median.h"

namespace rovio_sfm {
namespace {

// The views whose pictures are kept and that see enough; neighbours are indices among them.
std::vector<DepthView> ReadViews(const MapModel& model, const ReadPicture& read,
                                 const NeighborOptions& options) {
  const std::vector<ImageSurroundings> surroundings = ChooseNeighbors(model, options);
  std::vector<DepthView> views;
  std::vector<std::optional<uint32_t>> view_of(model.images.size());
  std::vector<uint32_t> image_of;
  size_t num_pictures = 0;
  for (uint32_t i = 0; i < model.images.size(); ++i) {
    const auto picture = read ? read(model.images[i]) : nullptr;
    if (picture == nullptr) continue;
    ++num_pictures;
    if (surroundings[i].near <= 0.0) continue;
    DepthView view = MakeDepthView(*picture, model.cameras[model.images[i].camera]);
    view.cam_from_map = model.images[i].cam_from_map;
    view.near = surroundings[i].near, view.far = surroundings[i].far;
    view_of[i] = static_cast<uint32_t>(views.size());
    image_of.push_back(i);
    views.push_back(std::move(view));
  }
  if (num_pictures == 0 && !model.images.empty()) {
    throw std::runtime_error("depth: no picture of the map's " +
                             std::to_string(model.images.size()) +
                             " keyframes is kept: expected a store with pictures (keep_images)");
  }
  for (size_t v = 0; v < views.size(); ++v) {
    for (const uint32_t other : surroundings[image_of[v]].neighbors) {
      if (view_of[other]) views[v].neighbors.push_back(*view_of[other]);
    }
  }
  return views;
}

std::vector<const DepthView*> NeighborsOf(const std::vector<DepthView>& views, size_t view) {
  std::vector<const DepthView*> neighbors;
  for (const uint32_t other : views[view].neighbors) neighbors.push_back(&views[other]);
  return neighbors;
}

// Runs a step of every view; empty where the progress ended it.
template <typename Step>
std::vector<DepthMap> ForAllViews(size_t num_views, const Step& step, Executor* executor,
                                  const std::function<bool()>& goes_on) {
  std::vector<DepthMap> maps;
  TaskGroup<DepthMap> tasks(executor);
  for (size_t i = 0; i < num_views; ++i) tasks.Add([&step, i] { return step(i); });
  while (tasks.NumPending() > 0) {
    maps.push_back(tasks.TakeNext());
    if (!goes_on()) return {};
  }
  return maps;
}

std::vector<DepthMap> CheckAll(const std::vector<DepthView>& views,
                               const std::vector<DepthMap>& depths, const AgreementOptions& options,
                               Executor* executor) {
  const auto check = [&](size_t i) {
    std::vector<const DepthMap*> theirs;
    for (const uint32_t other : views[i].neighbors) theirs.push_back(&depths[other]);
    return KeepAgreed(views[i], depths[i], NeighborsOf(views, i), theirs, options);
  };
  return ForAllViews(views.size(), check, executor, [] { return true; });
}

double MedianDepth(const std::vector<DepthView>& views) {
  std::vector<double> depths;
  for (const DepthView& view : views) depths.push_back(std::sqrt(view.near * view.far));
  return Median(std::move(depths));
}

}  // namespace

PointCloud MakeDenseCloud(const MapModel& model, const ReadPicture& read,
                          const DenseOptions& options, Executor* executor,
                          const DenseProgress& progress) {
  const std::vector<DepthView> views = ReadViews(model, read, options.neighbors);
  if (views.empty()) return {};
  size_t num_done = 0;
  const auto goes_on = [&] { return !progress || progress(++num_done, views.size()); };
  const auto estimate = [&](size_t i) {
    return EstimateDepth(views[i], NeighborsOf(views, i), options.sweep);
  };
  const std::vector<DepthMap> depths = ForAllViews(views.size(), estimate, executor, goes_on);
  if (depths.empty()) return {};
  const std::vector<DepthMap> agreed = CheckAll(views, depths, options.agreement, executor);
  FusionOptions fusion = options.fusion;
  fusion.voxel = options.voxel_share * MedianDepth(views);
  return FuseDepths(views, agreed, fusion);
}

}  // namespace rovio_sfm
