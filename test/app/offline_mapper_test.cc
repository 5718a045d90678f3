#include "rovio_sfm/app/offline_mapper.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <set>

#include "rovio_sfm/io/map_store.h"
#include "rovio_sfm/report/level_map.h"
#include "rovio_sfm/util/check_options.h"
#include "rovio_sfm/util/rng.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

constexpr int kNumImages = 8;

// Two textured walls, one nearer, past which a small camera moves sideways.
cv::Mat Wall(int width, uint64_t seed) {
  Rng rng(seed);
  cv::Mat wall(200, width, CV_8UC3);
  for (auto it = wall.begin<cv::Vec3b>(); it != wall.end<cv::Vec3b>(); ++it) {
    for (int c = 0; c < 3; ++c) (*it)[c] = static_cast<uint8_t>(rng.UniformInt(256));
  }
  cv::GaussianBlur(wall, wall, {0, 0}, 2.0);
  cv::normalize(wall, wall, 0, 255, cv::NORM_MINMAX);
  return wall;
}

std::vector<ImageEvent> SmallDrive(uint64_t seed = 1) {
  const cv::Mat far_wall = Wall(500, seed), near_wall = Wall(700, seed + 1);
  std::vector<ImageEvent> images;
  for (int i = 0; i < kNumImages; ++i) {
    cv::Mat image(200, 280, CV_8UC3);
    far_wall(cv::Rect(8 * i, 0, 280, 100)).copyTo(image.rowRange(0, 100));
    near_wall(cv::Rect(16 * i, 100, 280, 100)).copyTo(image.rowRange(100, 200));
    std::vector<uint8_t> png;
    cv::imencode(".png", image, png);
    ImageEvent event;
    event.stamp_ns = i * 1'000'000'000LL;
    event.name = std::to_string(i);
    event.encoded = std::make_shared<const std::vector<uint8_t>>(png);
    event.camera.fx = event.camera.fy = 250.0;
    event.camera.cx = 140.0, event.camera.cy = 100.0;
    event.camera.width = 280, event.camera.height = 200;
    images.push_back(event);
  }
  return images;
}

std::shared_ptr<const MapSnapshot> MapWith(int num_threads, OfflineMapperOptions options = {}) {
  options.num_threads = num_threads;
  options.frontend.extract.max_features = 300;
  OfflineMapper mapper(options, nullptr, nullptr);
  mapper.StartDrive("small");
  for (const ImageEvent& image : SmallDrive()) mapper.Add(image);
  return mapper.Finish();
}

TEST(OfflineMapper, GivesTheSameMapWithOneAndManyThreads) {
  const auto one = FindLargestMap(*MapWith(1)), three = FindLargestMap(*MapWith(3));
  ASSERT_EQ(one.has_value(), three.has_value());
  ASSERT_TRUE(one.has_value());
  const auto images = PosedImages(*one), same = PosedImages(*three);
  ASSERT_EQ(images.size(), same.size());
  EXPECT_EQ(images.size(), static_cast<size_t>(kNumImages));
  for (size_t i = 0; i < images.size(); ++i) {
    EXPECT_EQ(images[i].level_from_camera.reference_from_body.translation,
              same[i].level_from_camera.reference_from_body.translation);
  }
}

TEST(OfflineMapper, CountsWhatBecameOfTheImages) {
  OfflineMapper mapper({}, nullptr, nullptr);
  mapper.StartDrive("small");
  ImageEvent broken = SmallDrive().front();
  broken.encoded = std::make_shared<const std::vector<uint8_t>>(10, uint8_t{7});
  mapper.Add(broken);
  EXPECT_TRUE(mapper.Finish()->sessions.empty());
  EXPECT_EQ(mapper.frontend_counters().images, 1u);
  EXPECT_EQ(mapper.frontend_counters().refused, 1u);
}

// Runs that go on with one store, as --resume does.
class OfflineMapperResume : public testing::Test {
 protected:
  // Images of one folder of a run; gives the ids of its drives.
  std::map<DriveId, size_t> Run(const std::vector<std::vector<ImageEvent>>& folders,
                                bool localize = false) {
    OfflineMapperOptions options;
    options.frontend.extract.max_features = 300;
    options.localize = localize;
    MapStore store(folder_.Path() / "map.db", StoreAccess::kCreate);
    OfflineMapper mapper(options, nullptr, nullptr, &store);
    for (size_t i = 0; i < folders.size(); ++i) {
      mapper.StartDrive("folder_" + std::to_string(i));
      for (const ImageEvent& image : folders[i]) mapper.Add(image);
    }
    num_posed_ = 0;
    maps_.clear();
    const auto snapshot = mapper.Finish();
    for (const SessionSnapshot& session : snapshot->sessions) {
      for (const auto& block : session.frames) num_posed_ += block->size();
      if (!session.frames.empty()) maps_.insert(session.map);
    }
    reasons_ = mapper.reasons();
    return mapper.drives();
  }

  std::vector<DriveId> Drives() {
    std::vector<DriveId> ids;
    MapStore store(folder_.Path() / "map.db", StoreAccess::kRead);
    for (const DriveRecord& drive : store.frames().ReadDrives()) ids.push_back(drive.id);
    return ids;
  }

  TemporaryFolder folder_;
  size_t num_posed_ = 0;
  std::set<MapId> maps_;  // with a pose
  ReasonCounts reasons_;
};

TEST_F(OfflineMapperResume, MapsOtherPicturesOfTheSameTimesAsAnotherDrive) {
  const auto first = Run({SmallDrive(1)}), second = Run({SmallDrive(5)});
  EXPECT_EQ(num_posed_, 2u * kNumImages);
  EXPECT_NE(first.begin()->first, second.begin()->first);
  EXPECT_EQ(Drives().size(), 2u);
}

TEST_F(OfflineMapperResume, KnowsAFolderInAnotherPlaceOfTheCommand) {
  const auto before = Run({SmallDrive(1), SmallDrive(5)});
  const auto again = Run({SmallDrive(5), SmallDrive(1), SmallDrive(1)});
  EXPECT_EQ(Drives().size(), 3u) << "the third is given twice, and so a drive of its own";
  EXPECT_EQ(num_posed_, 3u * kNumImages);
  for (const auto& [drive, place] : before) EXPECT_EQ(again.at(drive), 1 - place);
}

TEST_F(OfflineMapperResume, GoesOnAfterTheEnd) {
  std::vector<ImageEvent> images = SmallDrive();
  images.resize(kNumImages / 2);
  Run({images});
  EXPECT_EQ(num_posed_, kNumImages / 2u);
  Run({SmallDrive()});
  EXPECT_EQ(num_posed_, static_cast<size_t>(kNumImages));
  EXPECT_EQ(Drives().size(), 1u);
  EXPECT_EQ(maps_.size(), 1u);
  EXPECT_TRUE(reasons_.empty());
}

TEST_F(OfflineMapperResume, TellsPicturesThatTheMapDoesNotHoldThere) {
  Run({SmallDrive()});
  std::vector<ImageEvent> every_other;
  for (size_t i = 0; i < kNumImages; i += 2) every_other.push_back(SmallDrive()[i]);
  Run({every_other});
  ASSERT_EQ(reasons_.size(), 1u);
  EXPECT_NE(reasons_.begin()->first.find("stride"), std::string::npos);
  EXPECT_EQ(reasons_.begin()->second, kNumImages / 2 - 1u);
}

TEST_F(OfflineMapperResume, WhatIsLocalisedIsNoDriveOfTheMap) {
  const auto mapped = Run({SmallDrive()});
  const auto localised = Run({SmallDrive()}, true);
  EXPECT_EQ(localised.count(mapped.begin()->first), 0u);
  EXPECT_EQ(Drives().size(), 1u);
}

TEST(OfflineMapperOptions, NamesTheBadOption) {
  std::string error;
  OfflineMapperOptions options;
  EXPECT_TRUE(IsValid(options, &error)) << error;
  options.num_threads = 0;
  EXPECT_FALSE(IsValid(options, &error));
  EXPECT_NE(error.find("num_threads"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
