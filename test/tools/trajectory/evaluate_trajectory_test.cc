#include "rovio_sfm/tools/trajectory/evaluate_trajectory.h"

#include <nlohmann/json.hpp>
#include <regex>

#include "tools/command_line.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

constexpr char kTruth[] = "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n2 1 1 0 0 0 0 1\n3 1 1 1 0 0 0 1\n";
constexpr char kHalfSize[] =
    "0 0 0 0 0 0 0 1\n1 0.5 0 0 0 0 0 1\n2 0.5 0.5 0 0 0 0 1\n3 0.5 0.5 0.5 0 0 0 1\n";

TEST(EvaluateTrajectoryCommand, PrintsJsonWithTheScaleErrorOfAMetricMap) {
  const TemporaryFolder folder;
  const std::string truth = folder.Write("truth.txt", kTruth);
  const std::string estimate = folder.Write("estimate.txt", kHalfSize);
  std::string printed;
  ASSERT_EQ(
      RunCommand(EvaluateTrajectoryCommand, {truth, estimate, "--json", "--metric"}, &printed), 0);
  const auto json = nlohmann::json::parse(printed);
  EXPECT_NEAR(json["ate_rmse_m"].get<double>(), 0.0, 1e-9);
  EXPECT_NEAR(json["scale_error"].get<double>(), 1.0, 1e-9);
  ASSERT_EQ(RunCommand(EvaluateTrajectoryCommand, {truth, estimate, "--json"}, &printed), 0);
  EXPECT_TRUE(nlohmann::json::parse(printed)["scale_error"].is_null());
}

TEST(EvaluateTrajectoryCommand, PrintsATable) {
  const TemporaryFolder folder;
  const std::string truth = folder.Write("truth.txt", kTruth);
  std::string printed;
  ASSERT_EQ(RunCommand(EvaluateTrajectoryCommand, {truth, truth}, &printed), 0);
  EXPECT_TRUE(std::regex_search(printed, std::regex("\ncompared +4\n"))) << printed;
  EXPECT_TRUE(std::regex_match(printed, std::regex("([a-z_0-9]+ +[^ \n]+\n)+"))) << printed;
}

TEST(EvaluateTrajectoryCommand, RefusesWhatItCannotCompare) {
  const TemporaryFolder folder;
  const std::string truth = folder.Write("truth.txt", kTruth);
  const std::string two = folder.Write("two.txt", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n");
  std::string printed;
  EXPECT_THROW(RunCommand(EvaluateTrajectoryCommand, {}, &printed), std::runtime_error);
  EXPECT_THROW(RunCommand(EvaluateTrajectoryCommand, {truth, truth, "--max-gap", "0"}, &printed),
               std::runtime_error);
  EXPECT_THROW(RunCommand(EvaluateTrajectoryCommand, {truth}, &printed), std::runtime_error);
  EXPECT_THROW(RunCommand(EvaluateTrajectoryCommand, {truth, two}, &printed), std::runtime_error);
  EXPECT_THROW(RunCommand(EvaluateTrajectoryCommand, {truth, "absent.txt"}, &printed),
               std::runtime_error);
}

}  // namespace
}  // namespace rovio_sfm
