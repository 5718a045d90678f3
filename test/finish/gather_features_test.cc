#include "rovio_sfm/finish/gather_features.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "finish/seen_wall.h"

namespace rovio_sfm {
namespace {

class GatherFeaturesTest : public testing::Test {
 protected:
  const SeenWall wall_;
  const FrameFeatures& stored_ = *wall_.stored[0];
  const std::vector<uint8_t> picture_ = WallPicture(0);
};

TEST_F(GatherFeaturesTest, PutsWhatIsFoundAfterWhatIsStored) {
  const FrameFeatures gathered = GatherFeatures(stored_, &picture_, SmallCamera(), {});
  const size_t count = gathered.keypoints.size();
  EXPECT_GT(count, 3 * stored_.keypoints.size());
  EXPECT_EQ(gathered.colors.size(), count);
  EXPECT_EQ(gathered.descriptors.Count(), count);
  for (size_t i = 0; i < stored_.keypoints.size(); ++i) {
    EXPECT_EQ(gathered.keypoints[i].x_px, stored_.keypoints[i].x_px);
  }
}

TEST_F(GatherFeaturesTest, FindsNothingTwice) {
  const FrameFeatures gathered = GatherFeatures(stored_, &picture_, SmallCamera(), {});
  for (size_t i = stored_.keypoints.size(); i < gathered.keypoints.size(); ++i) {
    for (const Keypoint& other : stored_.keypoints) {
      const Keypoint& found = gathered.keypoints[i];
      EXPECT_GE(std::hypot(found.x_px - other.x_px, found.y_px - other.y_px), 2.0f);
    }
  }
}

TEST_F(GatherFeaturesTest, KeepsTheStoredOnesWithoutPicture) {
  EXPECT_EQ(GatherFeatures(stored_, nullptr, SmallCamera(), {}).keypoints.size(),
            stored_.keypoints.size());
}

TEST_F(GatherFeaturesTest, LooksForTwiceTheStoredOnesWhereTheyFillTheBudget) {
  GatherOptions options;
  options.max_features = static_cast<int>(stored_.keypoints.size());
  const size_t count = GatherFeatures(stored_, &picture_, SmallCamera(), options).keypoints.size();
  EXPECT_GT(count, 3 * stored_.keypoints.size() / 2);
  EXPECT_LE(count, 3 * stored_.keypoints.size());
}

TEST_F(GatherFeaturesTest, FillsTheBudgetWithCornersWhereExtremaAreFew) {
  GatherOptions options;
  options.extract.sift_contrast = 0.2;  // no extremum of the wall has so much
  const size_t count = GatherFeatures(stored_, &picture_, SmallCamera(), options).keypoints.size();
  EXPECT_GT(count, 3 * stored_.keypoints.size());
}

TEST_F(GatherFeaturesTest, RefusesAPictureOfAnotherSize) {
  Camera camera = SmallCamera();
  camera.width = 640;
  try {
    GatherFeatures(stored_, &picture_, camera, {});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("320x240"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("640x240"), std::string::npos) << error.what();
  }
  const std::vector<uint8_t> broken = {1, 2, 3};
  EXPECT_THROW(GatherFeatures(stored_, &broken, camera, {}), std::runtime_error);
}

}  // namespace
}  // namespace rovio_sfm
