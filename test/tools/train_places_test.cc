#include "rovio_sfm/tools/train_places.h"

#include "rovio_sfm/app/place_model_file.h"
#include "tools/command_line.h"
#include "tools/training_folder.h"

namespace rovio_sfm {
namespace {

class TrainPlacesCommandTest : public testing::Test {
 protected:
  TrainPlacesCommandTest() {
    WriteTrainingImages(folder_, 5);
    for (const char* argument : {"--words", "20", "--features", "50", "--threads", "0"}) {
      arguments_.push_back(argument);
    }
    arguments_.push_back((folder_.Path() / "images").string());
    arguments_.insert(arguments_.end(), {"--out", ModelFile().string()});
  }

  std::filesystem::path ModelFile() const { return folder_.Path() / "a.places"; }
  int Run(const std::vector<std::string>& more) {
    std::vector<std::string> arguments = arguments_;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunCommand(TrainPlacesCommand, arguments, &printed_);
  }

  TemporaryFolder folder_;
  std::vector<std::string> arguments_;
  std::string printed_;
};

TEST_F(TrainPlacesCommandTest, WritesAModelAndSaysWhere) {
  EXPECT_EQ(Run({}), 0);
  EXPECT_EQ(LoadPlaceModel(ModelFile())->vocabulary.NumWords(), 20u);
  EXPECT_NE(printed_.find(ModelFile().string() + ": "), std::string::npos);
  EXPECT_NE(printed_.find("p(z=1|e=1)"), std::string::npos);
  EXPECT_NE(printed_.find("5/5"), std::string::npos);
}

TEST_F(TrainPlacesCommandTest, TakesTheFirstImagesOnly) {
  EXPECT_EQ(Run({"--images", "3"}), 0);
  EXPECT_EQ(LoadPlaceModel(ModelFile())->training_bags.size(), 3u);
  EXPECT_NE(MessageOf([&] {
              Run({"--images", "6", "--overwrite"});
            }).find("only 5"),
            std::string::npos);
}

TEST_F(TrainPlacesCommandTest, ReplacesAModelOnlyIfAllowed) {
  folder_.Write("a.places", "mine");
  EXPECT_NE(MessageOf([&] { Run({}); }).find("--overwrite"), std::string::npos);
  EXPECT_EQ(Run({"--overwrite", "--resume"}), 0);
}

TEST_F(TrainPlacesCommandTest, NamesAnOptionOutOfItsRange) {
  EXPECT_NE(MessageOf([&] {
              Run({"--p-z-given-e", "2"});
            }).find("p_z_given_e = 2"),
            std::string::npos);
}

TEST_F(TrainPlacesCommandTest, RefusesUnknownArguments) {
  EXPECT_THROW(Run({"--wrods", "3"}), std::runtime_error);
}

}  // namespace
}  // namespace rovio_sfm
