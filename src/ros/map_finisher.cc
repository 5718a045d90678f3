#include "rovio_sfm/ros/map_finisher.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <optional>
#include <thread>
#include <utility>

#include "rovio_sfm/finish/densify_map.h"
#include "rovio_sfm/finish/landmark_cloud.h"
#include "rovio_sfm/finish/make_dense_cloud.h"
#include "rovio_sfm/io/export_ply.h"
#include "rovio_sfm/report/level_session.h"
#include "rovio_sfm/ros/export_folder.h"
#include "rovio_sfm/ros/status.h"
#include "rovio_sfm/surface/reconstruct_surface.h"

namespace rovio_sfm {
namespace {

constexpr char kDepthStage[] = "depth", kMatchesStage[] = "matches", kSurfaceStage[] = "surface";

// One core is left to mapping.
int NumThreads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1); }

bool IsSource(const std::string& name) {
  using Goal = ReconstructSurfaceGoal;
  return name == Goal::LANDMARKS || name == Goal::DENSIFIED || name == Goal::DENSE;
}

ReadPicture PicturesOf(KeptFrames* frames) {
  return [frames](const ModelImage& image) { return frames->ReadImage(image.id); };
}

PointCloud Dense(const MapModel& model, KeptFrames* frames, const DenseProgress& progress) {
  Executor executor(NumThreads());
  return MakeDenseCloud(model, PicturesOf(frames), {}, &executor, progress);
}

// Empty where the progress ended it.
PointCloud Densified(const MapModel& model, KeptFrames* frames, const DenseProgress& progress) {
  Executor executor(NumThreads());
  const ReadFeatures features = [frames](const ModelImage& image) {
    return frames->ReadFeatures(image.id);
  };
  auto densified = DensifyMap(model, features, PicturesOf(frames), {}, &executor, progress);
  return densified ? std::move(densified->cloud) : PointCloud();
}

// Where a result is written too. An empty path: nowhere.
struct ResultFile {
  std::filesystem::path path;
  Overwrite overwrite = Overwrite::kRefuse;
};

// Nothing, and the status says why, where that may not be written.
template <typename Goal>
std::optional<ResultFile> FindFile(const Goal& goal, const std::string& output_dir,
                                   const std::string& file, Status* status) {
  if (goal.name.empty()) return ResultFile();
  const auto folder = FindExportFolder(output_dir, goal.name, status);
  if (!folder) return std::nullopt;
  const std::filesystem::path path = std::filesystem::absolute(*folder / file);
  if (!goal.overwrite && std::filesystem::exists(path)) {
    *status = AlreadyExists(path.string() + " exists and overwrite was false");
    return std::nullopt;
  }
  return ResultFile{path, goal.overwrite ? Overwrite::kAllow : Overwrite::kRefuse};
}

// What a goal that may go on works on, and where its result goes.
struct Task {
  ResultFile file;
  TakenMap taken;
};

// Nothing, and the result's status says why, where the file or the map is refused.
template <typename Goal, typename Result>
std::optional<Task> TakeUp(const Goal& goal, const FinishSources& sources, const char* file_name,
                           Result* result) {
  const auto file = FindFile(goal, sources.output_dir, file_name, &result->status);
  if (!file) return std::nullopt;
  Task task{*file, sources.take(goal.map)};
  result->status = task.taken.status;
  if (result->status.code != Status::OK) return std::nullopt;
  result->map = task.taken.gauge.map.value;
  return task;
}

// `done` tells what was made; the status is OK where that is written too.
template <typename Result>
void WriteResult(const ResultFile& file, const std::string& bytes, const std::string& done,
                 Result* result) {
  result->status = Ok(done);
  if (file.path.empty()) return;
  try {
    std::filesystem::create_directories(file.path.parent_path());
    WriteFile(file.path, bytes, file.overwrite);
    result->file = file.path.string();
  } catch (const std::exception& error) {  // a full disk, a read-only folder
    result->status = Internal(error.what());
  }
}

bool Holds(const MapGauge& gauge, const MapPicture& now) {
  const std::optional<MapGauge> newest = GaugeOf(now, gauge.map);
  return newest && *newest == gauge;
}

Status Outdated(MapId map) {
  return FailedPrecondition("map " + std::to_string(map.value) +
                            " was merged, taken apart or forgotten meanwhile: what was made of it "
                            "is not taken, ask again");
}

std::string Describe(size_t count, const std::string& what, const TakenMap& taken) {
  return std::to_string(count) + " " + what + " of map " + std::to_string(taken.gauge.map.value) +
         ", in " + taken.model.length_unit;
}

}  // namespace

// Ends the work where its goal is cancelled, or where its map lies otherwise now.
class MapFinisher::Watch {
 public:
  Watch(const FinishSources& sources, const MapGauge& gauge, const GoalProgress& progress)
      : sources_(sources), gauge_(gauge), progress_(progress) {}

  bool GoesOn(const std::string& stage, size_t num_done, size_t num_total) {
    if (!progress_(stage, num_done, num_total)) {
      End(MakeStatus(Status::CANCELLED, "the goal was cancelled"));
    } else if (!Holds(gauge_, sources_.picture())) {
      End(Outdated(gauge_.map));
    }
    return !has_ended_;
  }
  // The first reason is told.
  void End(const Status& why) {
    if (!has_ended_) why_ = why;
    has_ended_ = true;
  }
  bool has_ended() const { return has_ended_; }
  const Status& why() const { return why_; }

 private:
  const FinishSources& sources_;
  const MapGauge& gauge_;
  const GoalProgress& progress_;
  bool has_ended_ = false;
  Status why_;
};

DensifyResult MapFinisher::Densify(const DensifyGoal& goal, const GoalProgress& progress) {
  DensifyResult result;
  const bool by_depth = goal.method == DensifyGoal::DEPTH;
  if (!by_depth && goal.method != DensifyGoal::MATCHES) {
    result.status = InvalidArgument("method = " + goal.method + ": expected matches or depth");
    return result;
  }
  const char* const name = by_depth ? "dense.ply" : "densified.ply";
  const auto task = TakeUp(goal, sources_, name, &result);
  if (!task) return result;
  const auto& [file, taken] = *task;
  Watch watch(sources_, taken.gauge, progress);
  const CloudKind kind = by_depth ? CloudKind::kDense : CloudKind::kDensified;
  const CloudPtr cloud = MakeCloud(kind, taken, &watch);
  result.status = watch.why();
  if (!cloud) return result;
  result.num_points = static_cast<uint32_t>(cloud->size());
  WriteResult(file, file.path.empty() ? "" : DensePlyBytes(*cloud, taken.model.length_unit),
              Describe(cloud->size(), "points", taken), &result);
  return result;
}

ReconstructSurfaceResult MapFinisher::ReconstructSurface(const ReconstructSurfaceGoal& goal,
                                                         const GoalProgress& progress) {
  ReconstructSurfaceResult result;
  if (!IsSource(goal.source)) {
    result.status =
        InvalidArgument("source = " + goal.source + ": expected landmarks, densified or dense");
    return result;
  }
  const auto task = TakeUp(goal, sources_, "mesh.ply", &result);
  if (!task) return result;
  const auto& [file, taken] = *task;
  Watch watch(sources_, taken.gauge, progress);
  const CloudPtr cloud = CloudFor(goal.source, taken, &watch);
  const auto surface = cloud ? MakeSurface(taken, *cloud, &watch) : nullptr;
  result.status = watch.why();
  if (!surface) return result;
  result.num_points = static_cast<uint32_t>(cloud->size());
  result.num_triangles = static_cast<uint32_t>(surface->triangles.size());
  WriteResult(file, file.path.empty() ? "" : MeshPlyBytes(*surface, taken.model.length_unit),
              Describe(surface->triangles.size(), "triangles", taken), &result);
  return result;
}

MapFinisher::CloudPtr MapFinisher::MakeCloud(CloudKind kind, const TakenMap& taken, Watch* watch) {
  const bool is_dense = kind == CloudKind::kDense;
  CloudPtr cloud;
  try {
    const auto goes_on = [&](size_t num_done, size_t num_total) {
      return watch->GoesOn(is_dense ? kDepthStage : kMatchesStage, num_done, num_total);
    };
    KeptFrames frames = sources_.frames();
    cloud = std::make_shared<const PointCloud>(is_dense ? Dense(taken.model, &frames, goes_on)
                                                        : Densified(taken.model, &frames, goes_on));
  } catch (const std::exception& error) {  // nothing is kept, a store that cannot be read
    watch->End(Holds(taken.gauge, sources_.picture()) ? FailedPrecondition(error.what())
                                                      : Outdated(taken.gauge.map));
  }
  if (cloud && cloud->empty()) {
    watch->End(FailedPrecondition("the map's " + std::to_string(taken.model.images.size()) +
                                  " keyframes agree on no point"));
  }
  MapProducts made;
  (is_dense ? made.dense : made.densified) = cloud;
  return Keep(taken, made, watch) ? cloud : nullptr;
}

std::shared_ptr<const TriangleMesh> MapFinisher::MakeSurface(const TakenMap& taken,
                                                             const PointCloud& cloud,
                                                             Watch* watch) {
  const auto goes_on = [&](size_t num_done, size_t num_steps) {
    return watch->GoesOn(kSurfaceStage, num_done, num_steps);
  };
  const auto surface =
      std::make_shared<const TriangleMesh>(rovio_sfm::ReconstructSurface(cloud, {}, goes_on));
  if (surface->triangles.empty()) {
    watch->End(FailedPrecondition("surface: " + std::to_string(cloud.size()) +
                                  " points of the map make none: expected more, closer together"));
  }
  MapProducts made;
  made.surface = surface;
  return Keep(taken, made, watch) ? surface : nullptr;
}

MapFinisher::CloudPtr MapFinisher::CloudFor(const std::string& source, const TakenMap& taken,
                                            Watch* watch) {
  if (source == ReconstructSurfaceGoal::LANDMARKS) {
    return std::make_shared<const PointCloud>(LandmarkCloud(taken.model));
  }
  const CloudKind kind =
      source == ReconstructSurfaceGoal::DENSE ? CloudKind::kDense : CloudKind::kDensified;
  const CloudPtr kept = KeptCloud(kind, taken);
  return kept ? kept : MakeCloud(kind, taken, watch);
}

MapFinisher::CloudPtr MapFinisher::KeptCloud(CloudKind kind, const TakenMap& taken) {
  const auto products = shelf_->Fitting(taken.picture);
  const auto found = products.find(taken.gauge.map);
  if (found == products.end()) return nullptr;
  return kind == CloudKind::kDense ? found->second.dense : found->second.densified;
}

bool MapFinisher::Keep(const TakenMap& taken, const MapProducts& made, Watch* watch) {
  if (watch->has_ended()) return false;
  if (!shelf_->Put(taken.gauge, sources_.picture(), made)) {
    watch->End(Outdated(taken.gauge.map));
    return false;
  }
  KeepGrid(taken);
  return true;
}

void MapFinisher::MakeRootGrid() {
  const MapPicture picture = sources_.picture();
  const SessionSnapshot* root = FindRoot(*picture.snapshot);
  if (root == nullptr || !root->scale) return;
  const TakenMap taken = sources_.take(root->id.value);
  if (taken.status.code == Status::OK) KeepGrid(taken);
}

void MapFinisher::KeepGrid(const TakenMap& taken) {
  const SessionSnapshot* root = FindRoot(*taken.picture.snapshot);
  if (root == nullptr || !(root->map == taken.gauge.map) || !root->scale) return;
  const CloudPtr dense = KeptCloud(CloudKind::kDense, taken);
  MapProducts made;
  made.grid = std::make_shared<const OccupancyGridMap>(MakeGrid(taken.model, dense.get(), {}));
  shelf_->Put(taken.gauge, sources_.picture(), made);
}

}  // namespace rovio_sfm
