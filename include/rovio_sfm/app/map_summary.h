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

// A finished run over image folders.
struct MapRun {
  size_t num_images = 0;                                        // in the folders, after the stride
  std::map<std::string, std::vector<std::string>> image_names;  // by robot; may lack some
  std::shared_ptr<const MapSnapshot> snapshot;
  FrontendCounters frontend;
  MatchingFunnel funnel;
  MapperCounters mapper;
  std::vector<MergeReport> merges;
  std::map<std::string, StageTimes::Total> stages;
  std::map<std::string, std::vector<StampedPose>> ground_truth;  // by robot; may lack some
  std::map<std::string, YawByStamp> odometry;                    // by robot, as it was used
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

// The greatest memory of this process so far, MB.
double PeakRssMb();

}  // namespace rovio_sfm
