#include "rovio_sfm/finish/make_dense_cloud.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <type_traits>

#include "rovio_sfm/util/median.h"

namespace rovio_sfm {
namespace {

DepthView ViewOf(const std::vector<uint8_t>& picture, const ModelImage& image,
                 const MapModel& model) {
  try {
    return MakeDepthView(picture, model.cameras[image.camera]);
  } catch (const std::exception& error) {
    throw std::runtime_error("frame " + image.id.ToString() + ": " + error.what());
  }
}

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
    DepthView view = ViewOf(*picture, model.images[i], model);
    view.cam_from_map = model.images[i].cam_from_map;
    view.near = surroundings[i].near, view.far = surroundings[i].far;
    view.typical = surroundings[i].typical;
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

// What the neighbours of a view have, of one for every view.
template <typename OfView>
std::vector<const OfView*> OfNeighbors(const DepthView& view, const std::vector<OfView>& of_views) {
  std::vector<const OfView*> theirs;
  for (const uint32_t other : view.neighbors) theirs.push_back(&of_views[other]);
  return theirs;
}

// Whether to go on, asked after each view.
using GoesOn = std::function<bool()>;

// The results of a step for every view; empty where the progress ended it.
template <typename Step>
auto ForAllViews(size_t num_views, const Step& step, Executor* executor, const GoesOn& goes_on) {
  using Result = std::invoke_result_t<Step, size_t>;
  std::vector<Result> results;
  TaskGroup<Result> tasks(executor);
  for (size_t i = 0; i < num_views; ++i) tasks.Add([&step, i] { return step(i); });
  while (tasks.NumPending() > 0) {
    results.push_back(tasks.TakeNext());
    if (!goes_on()) return std::vector<Result>();
  }
  return results;
}

std::vector<DepthMap> EstimateAll(const std::vector<DepthView>& views, const SweepOptions& options,
                                  Executor* executor, const GoesOn& goes_on) {
  const auto estimate = [&](size_t i) {
    auto neighbors = OfNeighbors(views[i], views);
    neighbors.resize(std::min(neighbors.size(), options.max_neighbors));
    return EstimateDepth(views[i], neighbors, options);
  };
  return ForAllViews(views.size(), estimate, executor, goes_on);
}

// What views agree on, on its surfaces.
std::vector<MeasuredDepth> CheckAll(const std::vector<DepthView>& views,
                                    const std::vector<DepthMap>& depths,
                                    const DenseOptions& options, Executor* executor,
                                    const GoesOn& goes_on) {
  const auto check = [&](size_t i) {
    const MeasuredDepth agreed = KeepAgreed(views[i], depths[i], OfNeighbors(views[i], views),
                                            OfNeighbors(views[i], depths), options.agreement);
    return SmoothDepth(agreed, options.smoothing);
  };
  return ForAllViews(views.size(), check, executor, goes_on);
}

// Each point by those who see it best.
PointCloud FuseAll(const std::vector<DepthView>& views, const std::vector<MeasuredDepth>& checked,
                   const CertaintyOptions& certainty, const FusionOptions& fusion,
                   Executor* executor) {
  const auto choose = [&](size_t i) {
    return FindMostCertain(views[i], checked[i], OfNeighbors(views[i], views),
                           OfNeighbors(views[i], checked), certainty);
  };
  const auto telling = ForAllViews(views.size(), choose, executor, [] { return true; });
  std::vector<DepthMap> depths;
  for (const MeasuredDepth& measured : checked) depths.push_back(measured.depth);
  return FuseDepths(views, depths, telling, fusion);
}

double MedianDepth(const std::vector<DepthView>& views) {
  std::vector<double> depths;
  for (const DepthView& view : views) depths.push_back(view.typical);
  return Median(std::move(depths));
}

}  // namespace

PointCloud MakeDenseCloud(const MapModel& model, const ReadPicture& read,
                          const DenseOptions& options, Executor* executor,
                          const DenseProgress& progress) {
  const std::vector<DepthView> views = ReadViews(model, read, options.neighbors);
  if (views.empty()) return {};
  size_t num_done = 0;
  const auto goes_on = [&] { return !progress || progress(++num_done, 2 * views.size()); };
  const auto depths = EstimateAll(views, options.sweep, executor, goes_on);
  if (depths.empty()) return {};
  const auto checked = CheckAll(views, depths, options, executor, goes_on);
  if (checked.empty()) return {};
  FusionOptions fusion = options.fusion;
  fusion.voxel = options.voxel_share * MedianDepth(views);
  return FuseAll(views, checked, options.certainty, fusion, executor);
}

}  // namespace rovio_sfm
