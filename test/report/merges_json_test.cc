#include "rovio_sfm/report/merges_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace rovio_sfm {
namespace {

TEST(MergesJson, CountsVerdictsAndKeepsReasons) {
  std::vector<MergeReport> reports(3);
  reports[0].verdict = MergeVerdict::kAccepted;
  reports[1].verdict = MergeVerdict::kRefused;
  reports[1].reason = "absence";
  reports[2].verdict = MergeVerdict::kRefused;
  const auto json = MergesJson(reports);
  EXPECT_EQ(json["accepted"], 1);
  EXPECT_EQ(json["refused"], 2);
  EXPECT_EQ(json["provisional"], 0);
  EXPECT_EQ(json["reports"][1]["reason"], "absence");
}

TEST(MergesJson, IsEmptyWithoutReports) { EXPECT_TRUE(MergesJson({})["reports"].empty()); }

}  // namespace
}  // namespace rovio_sfm
