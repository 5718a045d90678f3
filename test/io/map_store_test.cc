#include "rovio_sfm/io/map_store.h"

#include <gtest/gtest.h>

#include "io/random_records.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

const DriveId kDrive{"rovio", 1, 0};

FrameEvent KeyframeAt(uint32_t index) {
  Rng rng(index);
  FrameEvent event = RandomEvent({kDrive, index}, rng);
  event.kind = FrameKind::kKeyframe;
  event.features = std::make_shared<FrameFeatures>(RandomFeatures(3, true, rng));
  event.tracks = {1, 2, 3};
  event.pairs.clear();
  return event;
}

class MapStoreFile : public ::testing::Test {
 protected:
  size_t NumKept() const {
    return MapStore(file_, StoreAccess::kRead).frames().ReadIndices(kDrive).size();
  }

  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.Path() / "map.db";
};

TEST_F(MapStoreFile, KeepsWhatWasCommittedAndNothingElse) {
  {
    MapStore store(file_, StoreAccess::kCreate);
    store.Put(KeyframeAt(0));
    store.Put(KeyframeAt(1));
    EXPECT_EQ(store.num_uncommitted(), 2u);
    EXPECT_EQ(NumKept(), 0u);  // to whoever else looks
    EXPECT_TRUE(store.Commit([] {}));
    EXPECT_EQ(store.num_uncommitted(), 0u);
    EXPECT_EQ(store.num_commits(), 1u);
    EXPECT_EQ(NumKept(), 2u);
    store.Put(KeyframeAt(2));
  }
  EXPECT_EQ(NumKept(), 2u);
}

TEST_F(MapStoreFile, GivesFeaturesWhateverTheCacheForgot) {
  MapStoreOptions options;
  options.max_cache_bytes = 1;
  MapStore store(file_, StoreAccess::kCreate, options);
  for (uint32_t i = 0; i < 5; ++i) store.Put(KeyframeAt(i));
  for (uint32_t i = 0; i < 5; ++i) {
    const auto features = store.Get({kDrive, i});
    ASSERT_NE(features, nullptr);
    EXPECT_EQ(features->descriptors.data, KeyframeAt(i).features->descriptors.data);
  }
  EXPECT_EQ(store.Get({kDrive, 9}), nullptr);
  EXPECT_EQ(store.error(), "");
}

TEST_F(MapStoreFile, CommitsNothingOfWhatFailsHalfway) {
  MapStore store(file_, StoreAccess::kCreate);
  store.Put(KeyframeAt(0));
  ASSERT_TRUE(store.Commit([] {}));
  store.Put(KeyframeAt(1));
  EXPECT_FALSE(store.Commit([&]() { throw StoreError("map.db: the disk is full"); }));
  EXPECT_EQ(store.error(), "map.db: the disk is full");
  store.Put(KeyframeAt(2));
  EXPECT_FALSE(store.Commit([] {}));
  EXPECT_EQ(NumKept(), 1u);
  for (uint32_t i = 0; i < 3; ++i) EXPECT_NE(store.Get({kDrive, i}), nullptr);
}

TEST_F(MapStoreFile, AFrameThatCannotBeReadIsMissingAndSaysWhy) {
  {
    MapStore store(file_, StoreAccess::kCreate);
    store.Put(KeyframeAt(0));
    store.Put(KeyframeAt(1));
    ASSERT_TRUE(store.Commit([] {}));
  }
  StoreDatabase(file_, StoreAccess::kWrite)
      .Execute("UPDATE frame SET keypoints = x'00' WHERE number = 1");
  MapStore store(file_, StoreAccess::kWrite);
  EXPECT_NE(store.Get({kDrive, 0}), nullptr);
  EXPECT_EQ(store.error(), "");
  EXPECT_EQ(store.Get({kDrive, 1}), nullptr);
  EXPECT_NE(store.error().find("map.db: keypoints: cut short"), std::string::npos);
  store.Put(KeyframeAt(2));
  EXPECT_TRUE(store.Commit([] {}));  // others are kept all the same
  EXPECT_EQ(NumKept(), 3u);
}

TEST_F(MapStoreFile, CopiesWhatWasCommitted) {
  MapStore store(file_, StoreAccess::kCreate);
  store.Put(KeyframeAt(0));
  ASSERT_TRUE(store.Commit([] {}));
  const std::filesystem::path copy = folder_.Path() / "copy.db";
  store.CopyTo(copy);
  MapStore copied(copy, StoreAccess::kRead);
  EXPECT_EQ(copied.frames().ReadIndices(kDrive).size(), 1u);
  EXPECT_NE(MessageOf([&] { store.CopyTo(copy); }).find("already exists"), std::string::npos);
}

TEST_F(MapStoreFile, NamesTheFileWhateverCannotBeRead) {
  { MapStore store(file_, StoreAccess::kCreate); }
  StoreDatabase(file_, StoreAccess::kWrite)
      .Execute("INSERT INTO waiting_match (position, place_match) VALUES (1, x'00')");
  MapStore store(file_, StoreAccess::kRead);
  EXPECT_EQ(MessageOf([&] { store.Read({}); }),
            file_.string() + ": match: cut short at drive: needs 8 bytes, 1 are left");
}

}  // namespace
}  // namespace rovio_sfm
