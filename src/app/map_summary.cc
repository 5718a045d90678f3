#include "rovio_sfm/app/map_summary.h"

#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>

#include "rovio_sfm/report/evaluation.h"
#include "rovio_sfm/report/evaluation_json.h"
#include "rovio_sfm/report/level_map.h"
#include "rovio_sfm/report/map_statistics.h"
#include "rovio_sfm/report/merges_json.h"

namespace rovio_sfm {
namespace {

using Json = nlohmann::ordered_json;

// Null: the drive is an earlier run's.
const DriveInput* InputOf(const MapRun& run, const DriveId& drive) {
  const auto it = run.drives.find(drive);
  return it == run.drives.end() ? nullptr : &run.inputs[it->second];
}

std::optional<EvaluationReport> Evaluate(const LevelMap& map, const MapRun& run,
                                         bool only_keyframes) {
  std::map<const DriveInput*, DriveEvaluation> drives;
  for (const PosedImage& image : PosedImages(map)) {
    if (only_keyframes && image.kind != FrameKind::kKeyframe) continue;
    const DriveInput* input = InputOf(run, image.id.drive);
    if (input == nullptr || input->ground_truth.empty()) continue;
    const auto [drive, is_new] = drives.try_emplace(input);
    if (is_new) drive->second.ground_truth = input->ground_truth;
    drive->second.estimate.push_back(image.level_from_camera);
  }
  std::vector<DriveEvaluation> list;
  for (const auto& [input, drive] : drives) list.push_back(drive);
  return EvaluateTrajectories(list);
}

void AddFrames(const MapRun& run, Json* json) {
  (*json)["frames"] = run.num_images;
  (*json)["keyframes"] = run.frontend.keyframes;
  (*json)["light_frames"] = run.frontend.light_frames;
  (*json)["dropped"] = run.num_images - run.frontend.keyframes - run.frontend.light_frames;
}

// The images that have a pose of their own in no map, by robot.
Json ImagesWithoutPose(const MapRun& run) {
  std::map<const DriveInput*, std::set<std::string>> posed;
  for (const SessionSnapshot& session : run.snapshot->sessions) {
    for (const auto& block : session.frames) {
      for (const FrameSnapshot& frame : *block) {
        if (!frame.weak) posed[InputOf(run, session.drive)].insert(frame.image_name);
      }
    }
  }
  Json without = Json::object();
  for (const DriveInput& input : run.inputs) {
    if (input.image_names.empty()) continue;
    Json& names = without[input.robot] = Json::array();
    for (const std::string& name : input.image_names) {
      if (posed[&input].count(name) == 0) names.push_back(name);
    }
  }
  return without;
}

void AddSessions(const MapSnapshot& snapshot, Json* json) {
  std::set<uint32_t> maps;
  size_t num_sessions = 0;
  for (const SessionSnapshot& session : snapshot.sessions) {
    if (session.frames.empty()) continue;
    ++num_sessions;
    maps.insert(session.map.value);
  }
  (*json)["sessions"] = num_sessions;
  (*json)["maps"] = maps.size();
}

std::vector<const SessionSnapshot*> RefinedSessions(const MapSnapshot& snapshot) {
  std::vector<const SessionSnapshot*> refined;
  for (const SessionSnapshot& session : snapshot.sessions) {
    if (!session.frames.empty() && !(session.camera == session.given_camera)) {
      refined.push_back(&session);
    }
  }
  return refined;
}

// The calibrations that pictures told otherwise.
Json RefinedCamerasJson(const MapSnapshot& snapshot) {
  Json cameras = Json::array();
  for (const SessionSnapshot* session : RefinedSessions(snapshot)) {
    const Camera& camera = session->camera;
    cameras.push_back({{"robot", session->drive.robot},
                       {"session", session->id.value},
                       {"fx", camera.fx},
                       {"fy", camera.fy},
                       {"cx", camera.cx},
                       {"cy", camera.cy}});
  }
  return cameras;
}

void AddStatistics(const MapStatistics& statistics, Json* json) {
  (*json)["registered"] = statistics.registered;
  (*json)["registered_keyframes"] = statistics.registered_keyframes;
  (*json)["landmarks"] = statistics.landmarks;
  (*json)["landmarks_two_views"] = statistics.landmarks_two_views;
  (*json)["landmarks_over_three_views"] = statistics.landmarks_over_three_views;
  (*json)["projections"] = statistics.projections;
  (*json)["mean_error_px"] = statistics.mean_error_px;
  (*json)["rms_counted_px"] = statistics.rms_counted_px;
  (*json)["rms_px"] = statistics.rms_px;
  (*json)["rms_n"] = statistics.rms_n;
}

// The scale that the map reports, and whether the true one lies within twice its sigma.
void AddScale(const std::optional<LevelMap>& map, const std::optional<EvaluationReport>& report,
              Json* json) {
  const bool metric = map && map->scale;
  (*json)["metric"] = metric;
  (*json)["scale_source"] = metric ? Json(map->scale->source) : Json();
  (*json)["scale_sigma"] = metric ? Json(map->scale->sigma_log) : Json();
  (*json)["scale_error"] = metric && report ? Json(report->scale_error) : Json();
  (*json)["scale_inside_two_sigma"] =
      metric && report
          ? Json(std::abs(std::log(report->world_from_map.scale)) <= 2.0 * map->scale->sigma_log)
          : Json();
}

// How much later odometry is stamped than images, where turns tell.
void AddOdometryDelay(const std::optional<LevelMap>& map, const MapRun& run, Json* json) {
  std::map<DriveId, YawByStamp> yaws;
  for (const auto& [drive, input] : run.drives) yaws[drive] = run.inputs[input].odometry;
  const auto delay = map ? MeasureOdometryDelay(*map, yaws) : std::nullopt;
  (*json)["odometry_delay_s"] = delay ? Json(delay->delay_s) : Json();
  (*json)["odometry_delay_sigma_s"] = delay ? Json(delay->sigma_s) : Json();
}

void AddErrors(const std::optional<LevelMap>& map, const MapRun& run, Json* json) {
  const auto all = map ? Evaluate(*map, run, false) : std::nullopt;
  const auto keyframes = map ? Evaluate(*map, run, true) : std::nullopt;
  (*json)["ate_rmse_m"] = all ? Json(all->ate_rmse_m) : Json();
  (*json)["ate_rmse_keyframes_m"] = keyframes ? Json(keyframes->ate_rmse_m) : Json();
  (*json)["rotation_rmse_deg"] = all ? Json(all->rotation_rmse_deg) : Json();
  (*json)["path_length_m"] = all ? Json(all->path_length_m) : Json();
  AddScale(map, all, json);
  (*json)["evaluation"] = all ? EvaluationJson(*all, map->scale.has_value()) : Json();
}

void AddCosts(const MapRun& run, Json* json) {
  (*json)["wall_s"] = run.wall_s;
  Json stages = Json::object();
  for (const auto& [stage, total] : run.stages) {
    stages[stage] =
        1e-6 * static_cast<double>(total.total_ns) / static_cast<double>(run.num_images);
  }
  (*json)["ms_per_frame"] = stages;
  (*json)["peak_rss_mb"] = run.peak_rss_mb;
}

// Of the features of a neighbouring pair's later image, the shares that each filter leaves.
Json FunnelJson(const MatchingFunnel& funnel) {
  if (funnel.features == 0) return Json();
  const auto share = [&funnel](uint64_t count) {
    return static_cast<double>(count) / static_cast<double>(funnel.features);
  };
  return {
      {"pairs", funnel.pairs},
      {"mean_features", static_cast<double>(funnel.features) / static_cast<double>(funnel.pairs)},
      {"ratio_share", share(funnel.ratio)},
      {"percentile_share", share(funnel.percentile)},
      {"one_to_one_share", share(funnel.one_to_one)},
      {"ransac_share", share(funnel.ransac)},
      {"guided_share", share(funnel.guided)}};
}

Json MapperJson(const MapRun& run) {
  const MapperCounters& counters = run.mapper;
  return {{"weak_frames", counters.weak_frames},
          {"refused_events", counters.refused_events},
          {"lost_sessions", counters.lost_sessions},
          {"rejoined_frames", run.num_rejoined},
          {"global_adjustments", counters.global_adjustments}};
}

Json PlacesJson(const PlaceCounters& places) {
  return {{"light_frames", places.light_frames},
          {"foreign_type", places.foreign_type},
          {"out_of_order", places.out_of_order},
          {"queries", places.queries},
          {"only_recent", places.only_recent},
          {"low_score", places.low_score},
          {"candidates", places.candidates},
          {"out_of_reach", places.out_of_reach},
          {"refused_geometry", places.refused_geometry},
          {"refused_spread", places.refused_spread},
          {"outdone", places.outdone},
          {"matches", places.matches},
          {"matched_queries", places.matched_queries},
          {"pairs", places.pairs}};
}

// What the thesis counts of tracks and points (§3.6, §5.2).
Json TracksJson(const MapRun& run, const std::optional<LevelMap>& map) {
  Json lengths = Json::object();
  if (map) {
    std::map<uint32_t, size_t> histogram;
    for (const MapLandmark& landmark : UniteLandmarks(*map)) {
      ++histogram[landmark.landmark.num_views];
    }
    for (const auto& [length, count] : histogram) lengths[std::to_string(length)] = count;
  }
  const auto matches = static_cast<double>(run.frontend.track_matches);
  const auto refused = static_cast<double>(run.frontend.refused_f1);
  return {{"matches", run.frontend.track_matches},
          {"refused_f1", run.frontend.refused_f1},
          {"f1_share", matches > 0.0 ? Json(refused / matches) : Json()},
          {"points_created", run.landmarks.created},
          {"points_united", run.landmarks.united},
          {"observations_deleted", run.landmarks.pruned_observations},
          {"length_histogram", lengths}};
}

}  // namespace

std::string WhyInMapUnits(const MapRun& run) {
  const std::optional<LevelMap> map = FindLargestMap(*run.snapshot);
  if (map && map->scale) return "";
  return run.why_no_scale.empty() ? WhyNoScale(run.motion) : run.why_no_scale;
}

size_t CountImagesWithoutPose(const MapRun& run) {
  size_t count = 0;
  for (const auto& names : ImagesWithoutPose(run)) count += names.size();
  return count;
}

std::string RefinedCameras(const MapRun& run) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(2) << std::showpos;
  for (const SessionSnapshot* session : RefinedSessions(*run.snapshot)) {
    const Camera &given = session->given_camera, &camera = session->camera;
    out << session->drive.robot << ": the pictures correct the calibration: focal length "
        << 100.0 * (camera.fx / given.fx - 1.0) << " %, centre (" << camera.cx - given.cx << ", "
        << camera.cy - given.cy << ") px\n";
  }
  return out.str();
}

Json MapSummaryJson(const MapRun& run) {
  const std::optional<LevelMap> map = FindLargestMap(*run.snapshot);
  Json json;
  AddFrames(run, &json);
  AddStatistics(map ? ComputeMapStatistics(*map) : MapStatistics(), &json);
  AddSessions(*run.snapshot, &json);
  json["images_without_pose"] = ImagesWithoutPose(run);
  AddErrors(map, run, &json);
  AddOdometryDelay(map, run, &json);
  json["refined_cameras"] = RefinedCamerasJson(*run.snapshot);
  json["matching"] = FunnelJson(run.funnel);
  json["mapper"] = MapperJson(run);
  json["merges"] = MergesJson(run.merges);
  const std::string why = WhyInMapUnits(run);
  json["why_in_map_units"] = why.empty() ? Json() : Json(why);
  json["tracks"] = TracksJson(run, map);
  json["places"] = PlacesJson(run.places);
  json["left_out"] = run.left_out;
  json["stopped"] = run.stopped;
  AddCosts(run, &json);
  return json;
}

Json DensifyJson(const DensifyCounts& counts) {
  return {{"landmarks_before", counts.before.num_points},
          {"landmarks", counts.after.num_points},
          {"projections_before", counts.before.num_projections},
          {"projections", counts.after.num_projections},
          {"rms_n_before", counts.before.rms_n},
          {"rms_n", counts.after.rms_n},
          {"rms_px", counts.after.rms_px},
          {"features", counts.num_features},
          {"matches", counts.num_matches},
          {"refused_f1", counts.num_refused_f1},
          {"barren_tracks", counts.num_barren_tracks},
          {"removed_by_reprojection", counts.num_removed_points},
          {"removed_by_depth", counts.num_inconsistent_depths}};
}

}  // namespace rovio_sfm
