#include "rovio_sfm/tools/evaluate_places.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "places/random_place_model.h"
#include "rovio_sfm/app/place_model_file.h"
#include "tools/command_line.h"
#include "tools/place_folder.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

// Two folders of views of two walls, and a place model of random words.
class EvaluatePlacesTest : public testing::Test {
 protected:
  EvaluatePlacesTest() {
    WritePlaceFolder(folder_.Path() / "a", 6, 1);
    WritePlaceFolder(folder_.Path() / "b", 2, 2);
    SavePlaceModel(RandomPlaceModel(60, 20, 1), folder_.Path() / "random.places",
                   Overwrite::kRefuse);
  }

  std::string PathOf(const std::string& name) const { return (folder_.Path() / name).string(); }

  int Run(std::vector<std::string> more) {
    std::vector<std::string> arguments{"--query",       PathOf("a") + "@4:5",
                                       "--database",    PathOf("a") + "@0:3",
                                       "--distractors", PathOf("b"),
                                       "--model",       PathOf("random.places"),
                                       "--min-score",   "-1e5",
                                       "--threads",     "1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunCommand(EvaluatePlacesCommand, arguments, &printed_);
  }

  TemporaryFolder folder_;
  std::string printed_;
};

TEST_F(EvaluatePlacesTest, WritesSummaryCurvesAndAnswers) {
  ASSERT_EQ(Run({"--truth", "overlaps", "--out", PathOf("out")}), 0) << printed_;
  std::ifstream file(PathOf("out/summary.json"));
  const auto summary = nlohmann::json::parse(file);
  EXPECT_EQ(summary["queries"], 2);
  EXPECT_EQ(summary["queries_with_positive"], 2);
  EXPECT_EQ(summary["places"], 6);
  for (const char* method : {"fabmap", "fabmap_verified", "tf_idf"}) {
    EXPECT_TRUE(summary[method].contains("area_under_curve")) << method;
  }
  EXPECT_TRUE(std::filesystem::exists(PathOf("out/curves.csv")));
  EXPECT_TRUE(std::filesystem::exists(PathOf("out/answers.csv")));
}

TEST_F(EvaluatePlacesTest, GoesOnAfterABrokenPhoto) {
  std::ofstream(PathOf("a/images/000002.png")) << "no picture";
  ASSERT_EQ(Run({"--truth", "overlaps", "--out", PathOf("out")}), 0) << printed_;
  std::ifstream file(PathOf("out/summary.json"));
  EXPECT_EQ(nlohmann::json::parse(file)["places"], 5);
}

TEST_F(EvaluatePlacesTest, TakesTruthFromAMatrix) {
  std::ofstream(PathOf("truth.txt")) << "1 0 -1 0\n0 0 0 0\n";
  ASSERT_EQ(Run({"--matrix", PathOf("truth.txt"), "--out", PathOf("out")}), 0) << printed_;
  std::ifstream file(PathOf("out/summary.json"));
  EXPECT_EQ(nlohmann::json::parse(file)["queries_with_positive"], 1);
}

TEST_F(EvaluatePlacesTest, AsksADriveAmongItsOwnPast) {
  ASSERT_EQ(RunCommand(EvaluatePlacesCommand,
                       {"--query", PathOf("a"), "--self", "2", "--prior", "--scores", "--truth",
                        "overlaps", "--model", PathOf("random.places"), "--threads", "1", "--out",
                        PathOf("self")},
                       &printed_),
            0)
      << printed_;
  std::ifstream file(PathOf("self/summary.json"));
  const auto summary = nlohmann::json::parse(file);
  EXPECT_EQ(summary["self_gap"], 2);
  EXPECT_EQ(summary["queries"], 6);
  EXPECT_EQ(summary["queries_with_positive"], 4);  // the first two know nothing
  EXPECT_TRUE(summary["fabmap"].contains("strict_recall_at_95_precision"));
  std::ifstream scores(PathOf("self/scores.csv"));
  std::string line;
  int num_lines = 0;
  while (std::getline(scores, line)) ++num_lines;
  EXPECT_EQ(num_lines, 7);
}

TEST_F(EvaluatePlacesTest, MeasuresNothingWithoutAPlaceThatIsRight) {
  const auto complaint = [&](const std::vector<std::string>& more) {
    return MessageOf([&] { Run(more); });
  };
  const std::string nothing = "no query has a place that is right, so nothing can be measured: ";
  const std::string file = PathOf("a/groundtruth.txt"), out = PathOf("out");
  std::filesystem::remove(file);
  EXPECT_EQ(complaint({"--out", out}), nothing + file + " is missing");
  std::ofstream(file) << "1.0 9 0 0 0 0 0 1\n5.0 0 0 0 0 0 0 1\n";
  EXPECT_EQ(complaint({"--out", out}),
            nothing +
                "no image of the database shows the same place as one of them, by their "
                "ground truth");
  std::ofstream(PathOf("truth.txt")) << "0 0 -1 0\n0 0 0 0\n";
  EXPECT_EQ(complaint({"--matrix", PathOf("truth.txt"), "--out", out}),
            nothing + PathOf("truth.txt") + " has no 1 that counts");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(EvaluatePlacesTest, MeasuresNothingWhereADriveHasNoPast) {
  const std::string message = MessageOf([&] {
    RunCommand(EvaluatePlacesCommand,
               {"--query", PathOf("a"), "--self", "100", "--model", PathOf("random.places"),
                "--threads", "1", "--out", PathOf("self")},
               &printed_);
  });
  EXPECT_EQ(message,
            "no query has a place that is right, so nothing can be measured: none shows the same "
            "place as one at least 100 images before, by their ground truth");
  EXPECT_FALSE(std::filesystem::exists(PathOf("self")));
}

TEST_F(EvaluatePlacesTest, NeedsADatabase) {
  EXPECT_THROW(RunCommand(EvaluatePlacesCommand, {"--query", PathOf("a"), "--out", PathOf("out")},
                          &printed_),
               std::runtime_error);
}

TEST_F(EvaluatePlacesTest, KeepsAnOlderSummaryUnlessTold) {
  ASSERT_EQ(Run({"--out", PathOf("out")}), 0) << printed_;
  EXPECT_THROW(Run({"--out", PathOf("out")}), std::runtime_error);
  EXPECT_EQ(Run({"--out", PathOf("out"), "--overwrite"}), 0);
}

TEST_F(EvaluatePlacesTest, RefusesOddOptions) {
  EXPECT_THROW(Run({"--out", PathOf("out"), "--candidates", "0"}), std::runtime_error);
  EXPECT_THROW(Run({"--out", PathOf("out"), "--truth", "hearsay"}), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(PathOf("out")));
}

}  // namespace
}  // namespace rovio_sfm
