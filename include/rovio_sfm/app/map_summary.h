#pragma once

#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "rovio_sfm/app/offline_mapper.h"
#include "rovio_sfm/finish/densify_map.h"
#include "rovio_sfm/frontend/frontend.h"
#include "rovio_sfm/io/trajectory_file.h"
#include "rovio_sfm/mapping/mapper_report.h"
#include "rovio_sfm/report/matching_funnel.h"
#include "rovio_sfm/report/measure_odometry_delay.h"
#include "rovio_sfm/scene/drive_state.h"
#include "rovio_sfm/scene/map_snapshot.h"
#include "rovio_sfm/scene/merge_report.h"
#include "rovio_sfm/util/reason_counts.h"
#include "rovio_sfm/util/stage_times.h"

namespace rovio_sfm {

// What a run is given as one drive; what is not known is empty.
struct DriveInput {
  std::string robot;
  std::vector<std::string> image_names;
  std::vector<StampedPose> ground_truth;
  YawByStamp odometry;  // as it was used
};

// A finished run over image folders.
struct MapRun {
  size_t num_images = 0;             // in the folders, after the stride
  std::vector<DriveInput> inputs;    // in the order in which the mapper started drives
  std::map<DriveId, size_t> drives;  // which of them the drives of this run came from
  std::shared_ptr<const MapSnapshot> snapshot;
  FrontendCounters frontend;
  MatchingFunnel funnel;
  MapperCounters mapper;
  std::vector<MergeReport> merges;
  std::map<std::string, StageTimes::Total> stages;
  PlaceCounters places;
  LandmarkCounts landmarks;
  uint64_t num_rejoined = 0;
  MotionCounts motion;
  std::string why_no_scale;  // what is known of why no scale can be; may be empty
  ReasonCounts left_out;     // images, messages, frames
  bool stopped = false;      // by a signal, before the end
  double wall_s = 0.0;
  double peak_rss_mb = 0.0;
};

// How many images of the run have a pose of their own in no map, of those whose names are known.
size_t CountImagesWithoutPose(const MapRun& run);

// A line for each session whose calibration its pictures told otherwise; empty: none.
std::string RefinedCameras(const MapRun& run);

// Why the largest map is in map units, in one sentence; empty where it is metric.
std::string WhyInMapUnits(const MapRun& run);

// The figures of summary.json by the definitions of docs/benchmarks.md, units in the names; null
// for what is not known.
nlohmann::ordered_json MapSummaryJson(const MapRun& run);

// Of the largest map, the object "densified".
nlohmann::ordered_json DensifyJson(const DensifyCounts& counts);

}  // namespace rovio_sfm
