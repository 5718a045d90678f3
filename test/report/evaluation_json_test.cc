#include "rovio_sfm/report/evaluation_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace rovio_sfm {
namespace {

TEST(EvaluationJson, WritesNullForWhatIsNotKnown) {
  EvaluationReport report;
  report.scale_error = 0.2;
  const auto json = EvaluationJson(report, false);
  EXPECT_TRUE(json["scale_error"].is_null());
  EXPECT_TRUE(json["rpe_rmse_m"].is_null());
  EXPECT_EQ(EvaluationJson(report, true)["scale_error"], 0.2);
}

}  // namespace
}  // namespace rovio_sfm
