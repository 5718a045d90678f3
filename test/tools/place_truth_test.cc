#include "rovio_sfm/tools/place_truth.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tools/place_folder.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

Rigid3 Pose(double x_m, double yaw_deg) {
  const double yaw_rad = yaw_deg * 3.14159265358979 / 180.0;
  return {Eigen::Quaterniond(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitY())),
          Eigen::Vector3d(x_m, 0.0, 0.0)};
}

TEST(PlaceTruth, LabelsOverlapsByShareAndAngle) {
  EXPECT_EQ(LabelOfOverlap(0.40, 24.9), PlaceLabel::kPositive);
  EXPECT_EQ(LabelOfOverlap(0.90, 25.0), PlaceLabel::kBetween);
  EXPECT_EQ(LabelOfOverlap(0.39, 0.0), PlaceLabel::kBetween);
  EXPECT_EQ(LabelOfOverlap(0.05, 90.0), PlaceLabel::kBetween);
  EXPECT_EQ(LabelOfOverlap(0.04, 0.0), PlaceLabel::kNegative);
}

TEST(PlaceTruth, LabelsPosesByDistanceAndRotation) {
  EXPECT_EQ(LabelOfPoses(Pose(0, 0), Pose(0.5, 29)), PlaceLabel::kPositive);
  EXPECT_EQ(LabelOfPoses(Pose(0, 0), Pose(0.6, 0)), PlaceLabel::kBetween);
  EXPECT_EQ(LabelOfPoses(Pose(0, 0), Pose(0.1, 45)), PlaceLabel::kBetween);
  EXPECT_EQ(LabelOfPoses(Pose(0, 0), Pose(1.6, 0)), PlaceLabel::kNegative);
  EXPECT_EQ(LabelOfPoses(Pose(0, 0), Pose(0.1, 61)), PlaceLabel::kNegative);
}

TEST(PlaceTruth, RollAroundTheOpticalAxisIsTheSameView) {
  const Rigid3 rolled{Eigen::Quaterniond(Eigen::AngleAxisd(1.5, Eigen::Vector3d::UnitZ())),
                      Eigen::Vector3d::Zero()};
  EXPECT_EQ(LabelOfPoses(Pose(0, 0), rolled), PlaceLabel::kPositive);
}

TEST(PlaceTruth, ReadsARangeOfAFolder) {
  const TemporaryFolder folder;
  WritePlaceFolder(folder.Path(), 8, 1);
  const PlaceImages images = ReadPlaceImages(folder.Path().string() + "@2:6", 2);
  EXPECT_EQ(images.indices, (std::vector<uint32_t>{2, 4, 6}));
  ASSERT_TRUE(images.poses[1]);
  EXPECT_NEAR(images.poses[1]->translation.x(), 0.4, 1e-9);
  EXPECT_EQ(ReadPlaceImages(folder.Path().string(), 3).indices.size(), 3u);
}

TEST(PlaceTruth, RefusesOddRanges) {
  const TemporaryFolder folder;
  WritePlaceFolder(folder.Path(), 3, 1);
  for (const char* range : {"@", "@1", "@1:", "@a:b", "@5:9"}) {
    EXPECT_THROW(ReadPlaceImages(folder.Path().string() + range, 1), std::runtime_error) << range;
  }
}

TEST(PlaceTruth, OverlapsHoldWithinOneFolderAndDistractorsAreNegative) {
  const TemporaryFolder folder;
  WritePlaceFolder(folder.Path() / "a", 10, 1);
  WritePlaceFolder(folder.Path() / "b", 2, 2);
  const auto query = ReadPlaceImages((folder.Path() / "a").string() + "@9:9", 1);
  const auto same = ReadPlaceImages((folder.Path() / "a").string() + "@0:8", 1);
  const auto other = ReadPlaceImages((folder.Path() / "b").string(), 1);
  const PlaceTruth truth = FindPlaceTruth({query}, {same, other}, 3, TruthSource::kOverlaps);
  ASSERT_EQ(truth.size(), 1u);
  ASSERT_EQ(truth[0].size(), 14u);
  EXPECT_EQ(truth[0][8], PlaceLabel::kPositive);  // 90 % shared
  EXPECT_EQ(truth[0][0], PlaceLabel::kBetween);   // 10 % shared
  for (size_t i = 9; i < 14; ++i) EXPECT_EQ(truth[0][i], PlaceLabel::kNegative);
}

TEST(PlaceTruth, PosesHoldBetweenFoldersAndAMissingOneIsNotScored) {
  const TemporaryFolder folder;
  WritePlaceFolder(folder.Path() / "a", 3, 1);
  WritePlaceFolder(folder.Path() / "b", 3, 2);
  const auto query = ReadPlaceImages((folder.Path() / "a").string(), 1);
  auto other = ReadPlaceImages((folder.Path() / "b").string(), 1);
  other.poses[2] = std::nullopt;
  const PlaceTruth truth = FindPlaceTruth({query}, {other}, 0, TruthSource::kPoses);
  EXPECT_EQ(truth[0][0], PlaceLabel::kPositive);
  EXPECT_EQ(truth[0][2], PlaceLabel::kBetween);
}

TEST(PlaceTruth, ReadsAMatrixAndNamesWhatIsOdd) {
  const TemporaryFolder folder;
  const auto file = folder.Path() / "truth.txt";
  std::ofstream(file) << "# one row a query\n1 0 -1\n0 0 1\n";
  const PlaceTruth truth = ReadPlaceTruth(file, 2, 3, 1);
  EXPECT_EQ(truth[0], (std::vector<PlaceLabel>{PlaceLabel::kPositive, PlaceLabel::kNegative,
                                               PlaceLabel::kBetween, PlaceLabel::kNegative}));
  EXPECT_THROW(ReadPlaceTruth(file, 3, 3, 0), std::runtime_error);
  EXPECT_THROW(ReadPlaceTruth(file, 2, 4, 0), std::runtime_error);
  std::ofstream(file) << "1 2 0\n";
  EXPECT_THROW(ReadPlaceTruth(file, 1, 3, 0), std::runtime_error);
}

}  // namespace
}  // namespace rovio_sfm
