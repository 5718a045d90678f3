#include "rovio_sfm/io/map_store_frames.h"

#include <gtest/gtest.h>

#include "io/random_records.h"
#include "rovio_sfm/io/map_store_schema.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

void ExpectSame(const PairMatches& a, const PairMatches& b) {
  EXPECT_EQ(a.other_index, b.other_index);
  EXPECT_EQ(a.counts.features, b.counts.features);
  EXPECT_EQ(a.counts.ratio, b.counts.ratio);
  EXPECT_EQ(a.counts.percentile, b.counts.percentile);
  EXPECT_EQ(a.counts.one_to_one, b.counts.one_to_one);
  EXPECT_EQ(a.counts.ransac, b.counts.ransac);
  EXPECT_EQ(a.counts.guided, b.counts.guided);
  EXPECT_EQ(a.verdict, b.verdict);
  EXPECT_EQ(a.cam_from_other.rotation.coeffs(), b.cam_from_other.rotation.coeffs());
  EXPECT_EQ(a.cam_from_other.translation, b.cam_from_other.translation);
  EXPECT_EQ(a.median_parallax_rad, b.median_parallax_rad);
  ASSERT_EQ(a.inliers.size(), b.inliers.size());
  for (size_t i = 0; i < a.inliers.size(); ++i) EXPECT_EQ(a.inliers[i].b, b.inliers[i].b);
}

void ExpectSameFeatures(const FrameFeatures& a, const FrameFeatures& b) {
  ASSERT_EQ(a.keypoints.size(), b.keypoints.size());
  for (size_t i = 0; i < a.keypoints.size(); ++i) {
    EXPECT_EQ(a.keypoints[i].x_px, b.keypoints[i].x_px);
    EXPECT_EQ(a.keypoints[i].x_normalized, b.keypoints[i].x_normalized);
  }
  EXPECT_EQ(a.colors, b.colors);
  EXPECT_EQ(a.descriptors.type, b.descriptors.type);
  EXPECT_EQ(a.descriptors.metric, b.descriptors.metric);
  EXPECT_EQ(a.descriptors.length, b.descriptors.length);
  EXPECT_EQ(a.descriptors.data, b.descriptors.data);
}

void ExpectSame(const FrameEvent& a, const FrameEvent& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.stamp_ns, b.stamp_ns);
  EXPECT_EQ(a.image_name, b.image_name);
  EXPECT_EQ(a.camera_frame, b.camera_frame);
  EXPECT_TRUE(a.camera == b.camera);
  EXPECT_EQ(a.tracks, b.tracks);
  EXPECT_EQ(a.blur, b.blur);
  ExpectSameFeatures(*a.features, *b.features);
  ASSERT_EQ(a.pairs.size(), b.pairs.size());
  for (size_t i = 0; i < a.pairs.size(); ++i) ExpectSame(a.pairs[i], b.pairs[i]);
  ASSERT_EQ(a.links.size(), b.links.size());
  for (size_t i = 0; i < a.links.size(); ++i) {
    EXPECT_EQ(a.links[i].a, b.links[i].a);
    EXPECT_EQ(a.links[i].b, b.links[i].b);
  }
  ASSERT_EQ(a.odometry.has_value(), b.odometry.has_value());
  if (a.odometry) {
    EXPECT_EQ(a.odometry->covariance, b.odometry->covariance);
    EXPECT_EQ(a.odometry->yaw_rad, b.odometry->yaw_rad);
  }
  ASSERT_EQ(a.base_from_camera.has_value(), b.base_from_camera.has_value());
  if (a.base_from_camera) {
    EXPECT_EQ(a.base_from_camera->translation, b.base_from_camera->translation);
  }
  ASSERT_EQ(a.jpeg == nullptr, b.jpeg == nullptr);
  if (a.jpeg != nullptr) {
    EXPECT_EQ(*a.jpeg, *b.jpeg);
  }
}

class MapStoreFrames : public ::testing::Test {
 protected:
  MapStoreFrames() { OpenSchema(StoreAccess::kCreate, &database_); }

  std::vector<FrameEvent> PutRandomFrames(StoredFrames* frames) {
    std::vector<FrameEvent> events;
    for (uint32_t i = 0; i < 100; ++i) {
      Rng rng(i);
      const DriveId drive{i % 2 == 0 ? "first" : "second", -5 + int64_t{i % 2}, UINT32_MAX};
      events.push_back(RandomEvent({drive, i < 98 ? i : UINT32_MAX - 1}, rng));
      frames->PutFrame(events.back(), true);
    }
    return events;
  }
  std::string ErrorAfter(const std::string& change) {
    Rng rng(1);
    FrameEvent event = RandomEvent({{"first", 1, 0}, 1}, rng);
    event.features = std::make_shared<FrameFeatures>(RandomFeatures(3, true, rng));
    event.tracks = {1, 2, 3};
    event.pairs = {RandomPair(3, rng)};
    StoredFrames frames(&database_);
    frames.PutFrame(event, true);
    database_.Execute("PRAGMA ignore_check_constraints = ON;" + change);
    return MessageOf([&] { frames.ReadEvent(event.id, EventParts::kAll); });
  }

  const TemporaryFolder folder_;
  StoreDatabase database_{folder_.Path() / "map.db", StoreAccess::kCreate};
};

TEST_F(MapStoreFrames, GiveBackRandomEventsToWhoeverAsks) {
  StoredFrames writer(&database_);
  const std::vector<FrameEvent> events = PutRandomFrames(&writer);
  const StoredFrames reader(&database_);  // knows what the file says
  for (const StoredFrames* frames : std::initializer_list<const StoredFrames*>{&writer, &reader}) {
    for (const FrameEvent& event : events) {
      const auto again = frames->ReadEvent(event.id, EventParts::kAll);
      ASSERT_TRUE(again);
      ExpectSame(*again, event);
    }
  }
  EXPECT_EQ(reader.ReadDrives().size(), 2u);
  const std::vector<uint32_t> indices = reader.ReadIndices(events[0].id.drive);
  EXPECT_EQ(indices.size(), 50u);
  EXPECT_EQ(indices.back(), UINT32_MAX - 1);
}

TEST_F(MapStoreFrames, GiveBareEventsWithoutWhatIsLarge) {
  StoredFrames frames(&database_);
  for (const FrameEvent& event : PutRandomFrames(&frames)) {
    const auto bare = frames.ReadEvent(event.id, EventParts::kBare);
    ASSERT_TRUE(bare);
    EXPECT_EQ(bare->tracks, event.tracks);
    EXPECT_EQ(bare->features->keypoints.size(), event.features->keypoints.size());
    EXPECT_TRUE(bare->features->descriptors.data.empty());
    EXPECT_TRUE(bare->pairs.empty() && bare->links.empty());
    EXPECT_EQ(bare->jpeg, nullptr);
  }
}

TEST_F(MapStoreFrames, GiveFeaturesOfKeyframesAlone) {
  StoredFrames frames(&database_);
  for (const FrameEvent& event : PutRandomFrames(&frames)) {
    const auto features = frames.ReadFeatures(event.id);
    ASSERT_EQ(features != nullptr, event.kind == FrameKind::kKeyframe);
    if (features != nullptr) ExpectSameFeatures(*features, *event.features);
  }
}

TEST_F(MapStoreFrames, GiveNothingForUnknownFrames) {
  StoredFrames frames(&database_);
  PutRandomFrames(&frames);
  for (const FrameId& id : {FrameId{{"first", -5, UINT32_MAX}, 1}, FrameId{{"third", 1, 0}, 0}}) {
    EXPECT_FALSE(frames.ReadEvent(id, EventParts::kAll));
    EXPECT_EQ(frames.ReadFeatures(id), nullptr);
    EXPECT_EQ(frames.ReadImage(id), nullptr);
  }
  EXPECT_TRUE(frames.ReadIndices({"third", 1, 0}).empty());
  EXPECT_FALSE(frames.FindRow({"third", 1, 0}));
  EXPECT_NE(MessageOf([&] { frames.DriveAt(9); }).find("map.db: drive 9 is missing"),
            std::string::npos);
}

TEST_F(MapStoreFrames, KeepAFrameAsItCameFirst) {
  StoredFrames frames(&database_);
  Rng rng(1);
  const FrameEvent event = RandomEvent({{"first", 1, 0}, 1}, rng);
  FrameEvent other = RandomEvent(event.id, rng);
  frames.PutFrame(event, true);
  frames.PutFrame(other, true);
  ExpectSame(*frames.ReadEvent(event.id, EventParts::kAll), event);
}

TEST_F(MapStoreFrames, LeaveImagesOutWhereTheyAreNotWanted) {
  StoredFrames frames(&database_);
  Rng rng(1);
  FrameEvent event = RandomEvent({{"first", 1, 0}, 1}, rng);
  event.jpeg = std::make_shared<std::vector<uint8_t>>(5);
  frames.PutFrame(event, false);
  EXPECT_EQ(frames.ReadImage(event.id), nullptr);
}

TEST_F(MapStoreFrames, KeepTheStateOfADriveWithFrames) {
  StoredFrames frames(&database_);
  DriveState state;
  state.next_index = 7;
  state.held = {3, 5};
  frames.PutState({"first", -5, UINT32_MAX}, state);  // no frame of it came: nothing to go on with
  EXPECT_TRUE(frames.ReadDrives().empty());
  PutRandomFrames(&frames);
  EXPECT_FALSE(frames.ReadDrives()[0].state.next_index);
  frames.PutState({"first", -5, UINT32_MAX}, state);
  EXPECT_EQ(frames.ReadDrives()[0].state.next_index, 7u);
  EXPECT_EQ(frames.ReadDrives()[0].state.held, state.held);
}

// What a spoilt file says must not reach the mapper: it would look for features that are not there.
TEST_F(MapStoreFrames, RefuseRowsThatContradictEachOther) {
  for (const auto& [change, expected] : std::initializer_list<std::pair<const char*, const char*>>{
           {"UPDATE frame SET tracks = x'0000000000000000'",
            "map.db: tracks: 1 values, expected 3"},
           {"UPDATE frame SET keypoints = x'00'", "map.db: keypoints: cut short"},
           {"UPDATE descriptors SET length = length + 1", "map.db: descriptors: "},
           {"UPDATE descriptors SET length = -1", "map.db: descriptors"},
           {"UPDATE descriptors SET type = 9", "map.db: descriptors.type = 9: expected 0 to 4"},
           {"UPDATE pair SET verdict = 9", "map.db: pair.verdict = 9: expected 0 to 3"},
           {"UPDATE pair SET pose = x'00'", "map.db: pose: cut short"},
           {"UPDATE pair SET inliers = x'0100000000000000030000000000000000000000'",
            "map.db: inliers: "}}) {
    const std::string error = ErrorAfter(change);
    EXPECT_NE(error.find(expected), std::string::npos) << change << ": " << error;
    database_.Execute(
        "DELETE FROM pair; DELETE FROM track_link; DELETE FROM image; DELETE FROM descriptors; "
        "DELETE FROM frame; DELETE FROM drive");
  }
}

}  // namespace
}  // namespace rovio_sfm
