#include "rovio_sfm/app/finish_map.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "dense/textured_room.h"

namespace rovio_sfm {
namespace {

TEST(FinishedMap, ReadsEachPictureOnce) {
  MapModel model;
  model.cameras.push_back(SmallCamera());
  model.images.resize(2);
  int num_read = 0;
  const PictureSource pictures = [&](const ModelImage&) {
    ++num_read;
    std::vector<uint8_t> png;
    cv::imencode(".png", SeeWall(0.0, 0.0, 2.0), png);
    return std::make_shared<const std::vector<uint8_t>>(std::move(png));
  };
  const ReadFeatures features;
  FinishedMap map(model, pictures, features);
  EXPECT_TRUE(map.DenseCloud().empty());  // no image sees enough points
  EXPECT_TRUE(map.Surface().triangles.empty());
  EXPECT_TRUE(map.DenseCloud().empty());
  EXPECT_EQ(num_read, 2);
}

TEST(FinishedMap, SaysThatPicturesAreMissing) {
  MapModel model;
  model.images.resize(1);
  const PictureSource none;
  const ReadFeatures features;
  FinishedMap map(model, none, features);
  EXPECT_THROW(map.Surface(), std::runtime_error);
}

}  // namespace
}  // namespace rovio_sfm
