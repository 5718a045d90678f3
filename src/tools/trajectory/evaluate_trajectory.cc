#include "rovio_sfm/tools/trajectory/evaluate_trajectory.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>
#include <string>

#include "rovio_sfm/report/evaluation.h"
#include "rovio_sfm/report/evaluation_json.h"
#include "rovio_sfm/util/parse_arguments.h"

namespace rovio_sfm {
namespace {

std::vector<DriveEvaluation> ReadDrives(const std::vector<std::string>& files) {
  if (files.size() % 2 != 0) throw std::runtime_error("expected pairs GROUND_TRUTH ESTIMATE");
  std::vector<DriveEvaluation> drives;
  for (size_t i = 0; i < files.size(); i += 2) {
    drives.push_back({ReadTrajectory(files[i + 1]), ReadTrajectory(files[i])});
  }
  return drives;
}

void PrintTable(const nlohmann::ordered_json& figures, std::ostream& out) {
  size_t width = 0;
  for (const auto& [name, value] : figures.items()) width = std::max(width, name.size());
  for (const auto& [name, value] : figures.items()) {
    out << std::left << std::setw(static_cast<int>(width)) << name << " " << value.dump() << "\n";
  }
}

}  // namespace

int EvaluateTrajectoryCommand(int argc, const char* const* argv, std::ostream& out) {
  CLI::App app("Compares trajectories (TUM format) with the truth, after one similarity for all");
  std::vector<std::string> files;
  bool json = false, metric = false;
  double max_gap_s = 1e-9 * static_cast<double>(kMaxTruthGapNs);
  app.add_option("files", files, "GROUND_TRUTH ESTIMATE, one pair per drive")->required();
  app.add_flag("--json", json, "print JSON instead of a table");
  app.add_flag("--metric", metric, "the map is metric: report its scale error");
  app.add_option("--max-gap", max_gap_s, "widest gap of the truth to bridge, s")
      ->check(CLI::Range(1e-6, 1e6));
  if (const auto status = ParseArguments(&app, argc, argv, out)) return *status;
  const auto report =
      EvaluateTrajectories(ReadDrives(files), static_cast<int64_t>(max_gap_s * 1e9));
  if (!report) throw std::runtime_error("fewer than three poses with ground truth, or on one line");
  const nlohmann::ordered_json figures = EvaluationJson(*report, metric);
  if (json) {
    out << figures.dump(2) << "\n";
  } else {
    PrintTable(figures, out);
  }
  return 0;
}

}  // namespace rovio_sfm
