#include "rovio_sfm/ros/kept_frames.h"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>

#include "mapping/mapped_drive.h"
#include "rovio_sfm/ros/frame_event_message.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

using Bytes = std::vector<uint8_t>;

// A store that holds the image of the drive's first frame.
std::filesystem::path StoreWithOneImage(const TemporaryFolder& folder, FrameEvent event) {
  const std::filesystem::path file = folder.Path() / "map.db";
  event.jpeg = std::make_shared<const Bytes>(Bytes{1, 2});
  MapStore store(file, StoreAccess::kCreate);
  store.Put(event);
  EXPECT_TRUE(store.Commit([] {}));
  return file;
}

TEST(KeptFrames, AreThoseOfEventsThenThoseOfTheStore) {
  const TemporaryFolder folder;
  const SyntheticDrive drive = MakeSyntheticDrive({});
  auto event = boost::make_shared<FrameEventMsg>();
  event->jpeg = {3, 4, 5};
  KeptFrames frames({{drive.events[1].id, event}}, StoreWithOneImage(folder, drive.events[0]));
  ASSERT_TRUE(frames.ReadImage(drive.events[0].id));
  EXPECT_EQ(*frames.ReadImage(drive.events[0].id), (Bytes{1, 2}));
  ASSERT_TRUE(frames.ReadImage(drive.events[1].id));
  EXPECT_EQ(*frames.ReadImage(drive.events[1].id), (Bytes{3, 4, 5}));
  EXPECT_FALSE(frames.ReadImage(drive.events[2].id));
}

TEST(KeptFrames, NeedNoStore) {
  KeptFrames frames({}, "/no/such/map.db");
  EXPECT_FALSE(frames.ReadImage(FrameId()));
  EXPECT_FALSE(frames.ReadFeatures(FrameId()));
}

TEST(KeptFrames, HaveFeaturesWithDescriptorsFromBoth) {
  const TemporaryFolder folder;
  const SyntheticDrive drive = MakeSyntheticDrive({});
  const auto held = boost::make_shared<FrameEventMsg>(ToMessage(drive.events[1]));
  KeptFrames frames({{drive.events[1].id, held}}, StoreWithOneImage(folder, drive.events[0]));
  for (size_t i = 0; i < 2; ++i) {
    const auto features = frames.ReadFeatures(drive.events[i].id);
    ASSERT_TRUE(features);
    EXPECT_EQ(features->descriptors.data, drive.events[i].features->descriptors.data);
    EXPECT_EQ(features->keypoints.size(), drive.events[i].features->keypoints.size());
  }
  EXPECT_FALSE(frames.ReadFeatures(drive.events[2].id));
}

}  // namespace
}  // namespace rovio_sfm
