#include "rovio_sfm/tools/train_place_model.h"

#include <map>

#include "rovio_sfm/util/check_options.h"
#include "tools/training_folder.h"

namespace rovio_sfm {
namespace {

class TrainPlacesTest : public testing::Test {
 protected:
  TrainPlacesTest() : images_(WriteTrainingImages(folder_, 6)) {}

  TrainingResult Train(const TrainPlacesOptions& options, const std::string& work, bool resume,
                       int num_threads, const TrainingProgress& progress) {
    Executor executor(num_threads);
    return TrainPlaces(images_, options, TrainingCheckpoint(folder_.Path() / work), resume,
                       &executor, progress);
  }
  TrainingResult Train(const TrainPlacesOptions& options, int num_threads) {
    return Train(options, "work", false, num_threads, [](const std::string&, size_t, size_t) {});
  }

  TemporaryFolder folder_;
  std::vector<std::filesystem::path> images_;
};

TEST_F(TrainPlacesTest, MakesAValidModel) {
  const TrainingResult result = Train(QuickTraining(), 0);
  std::string error;
  EXPECT_TRUE(result.model.IsValid(&error)) << error;
  EXPECT_EQ(result.model.vocabulary.NumWords(), 40u);
  EXPECT_EQ(result.model.training_bags.size(), 6u);
  EXPECT_GT(result.num_iterations, 0u);
  EXPECT_GT(result.detector.num_words, 0u);
  EXPECT_EQ(result.model.provenance,
            "train_places: 6 images, 40 words, 60 features an image, seed 1");
}

TEST_F(TrainPlacesTest, GivesTheSameBytesWithAnyNumberOfThreads) {
  const std::string alone = EncodePlaceModel(Train(QuickTraining(), 0).model);
  EXPECT_EQ(EncodePlaceModel(Train(QuickTraining(), 2).model), alone);
}

struct Interruption {};

TEST_F(TrainPlacesTest, GoesOnWhereItWasInterrupted) {
  const std::string whole = EncodePlaceModel(Train(QuickTraining(), 0).model);
  const auto interrupt = [](const std::string& step, size_t done, size_t) {
    if (step == "words" && done == 2) throw Interruption();
  };
  EXPECT_THROW(Train(QuickTraining(), "broken_off", false, 0, interrupt), Interruption);
  std::map<std::string, size_t> num_reports;
  const auto count = [&](const std::string& step, size_t, size_t) { ++num_reports[step]; };
  const TrainingResult resumed = Train(QuickTraining(), "broken_off", true, 0, count);
  EXPECT_EQ(EncodePlaceModel(resumed.model), whole);
  EXPECT_EQ(num_reports.count("features"), 0u);  // not found again
  EXPECT_LT(num_reports["words"], resumed.num_iterations + 1);
}

TEST_F(TrainPlacesTest, FindsWordsAnewForOtherOptions) {
  Train(QuickTraining(), 0);
  TrainPlacesOptions fewer = QuickTraining();
  fewer.cluster.num_words = 20;
  const auto ignore = [](const std::string&, size_t, size_t) {};
  EXPECT_EQ(Train(fewer, "work", true, 0, ignore).model.vocabulary.NumWords(), 20u);
}

TEST_F(TrainPlacesTest, UsesTheDetectorItIsGiven) {
  TrainPlacesOptions options = QuickTraining();
  options.p_z_given_e = 0.27;
  EXPECT_EQ(Train(options, 0).model.detector.p_z_given_e, 0.27);
  options.p_z_given_e = 0.0;
  const TrainingResult measured = Train(options, 0);
  EXPECT_EQ(measured.model.detector.p_z_given_e, std::max(0.01, measured.detector.p_z_given_e));
}

TEST_F(TrainPlacesTest, RefusesImagesWithoutFeatures) {
  images_ = {folder_.Path() / "plain.png"};
  cv::imwrite(images_[0].string(), cv::Mat(120, 160, CV_8UC3, cv::Scalar::all(90)));
  EXPECT_NE(MessageOf([&] { Train(QuickTraining(), 0); }), "");
}

TEST(TrainPlacesOptions, NamesWhatDoesNotFit) {
  std::string error;
  EXPECT_TRUE(IsValid(TrainPlacesOptions{}, &error)) << error;
  TrainPlacesOptions options;
  options.frontend.extract.type = DescriptorType::kOrb;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_EQ(error, "frontend.extract.type = orb: expected sift");
}

}  // namespace
}  // namespace rovio_sfm
