#include "rovio_sfm/ros/map_store_files.h"

#include <gtest/gtest.h>

#include "mapping/mapped_drive.h"
#include "rovio_sfm/app/store_folder.h"
#include "rovio_sfm/ros/conversions.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

class MapStoreFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const FrameEvent& event : drive_.events) maps_.store().Put(event);
    ASSERT_TRUE(maps_.store().Commit([] {}));
  }
  GetFramesResponse Page(uint32_t first, uint32_t max_frames) const {
    GetFramesRequest request;
    request.first = ToMessage(FrameId{drive_.events[0].id.drive, first});
    request.max_frames = max_frames;
    return PageOfStore(folder_.Path().string(), request);
  }
  SaveMapResponse Save(const std::string& name, bool overwrite) const {
    SaveMapRequest request;
    request.name = name;
    request.overwrite = overwrite;
    return CopyStore(folder_.Path().string(), request);
  }

  const SyntheticDrive drive_ = MakeSyntheticDrive({});
  TemporaryFolder folder_;
  StoreFolder maps_{folder_.Path(), ExistingStore::kRefuse};
};

TEST_F(MapStoreFiles, PagesWhatWasCommitted) {
  const GetFramesResponse page = Page(3, 4);
  ASSERT_EQ(page.frames.size(), 4u);
  EXPECT_EQ(page.frames.front().id.index, 3u);
  EXPECT_EQ(page.next_index, 7u);
  EXPECT_TRUE(page.more);
  EXPECT_EQ(page.frames[0].descriptors.size(), drive_.events[3].features->descriptors.data.size());
}

TEST_F(MapStoreFiles, SaysWhereThereIsNothingMore) {
  const GetFramesResponse page = Page(static_cast<uint32_t>(drive_.events.size()), 4);
  EXPECT_EQ(page.status.code, Status::NOT_FOUND);
  EXPECT_FALSE(page.more);
}

TEST_F(MapStoreFiles, CopiesWhileTheStoreIsOpen) {
  const SaveMapResponse response = Save("copy.db", false);
  ASSERT_EQ(response.status.code, Status::OK) << response.status.message;
  MapStore copy(response.file, StoreAccess::kRead);
  EXPECT_EQ(copy.frames().ReadIndices(drive_.events[0].id.drive).size(), drive_.events.size());
  EXPECT_EQ(Save("copy.db", false).status.code, Status::ALREADY_EXISTS);
  EXPECT_EQ(Save("copy.db", true).status.code, Status::OK);
}

TEST_F(MapStoreFiles, PutsNoStoreInAFoldersPlace) {
  std::filesystem::create_directory(folder_.Path() / "folder.db");
  const Status status = Save("folder.db", true).status;
  EXPECT_EQ(status.code, Status::INVALID_ARGUMENT);
  EXPECT_NE(status.message.find("name = folder.db: is a folder"), std::string::npos);
}

TEST_F(MapStoreFiles, RefusesNamesThatLeadElsewhere) {
  for (const char* name : {"", "map.db", "copy", "../copy.db", ".db", ".hidden.db", "a b.db"}) {
    const Status status = Save(name, true).status;
    EXPECT_EQ(status.code, Status::INVALID_ARGUMENT) << name;
    EXPECT_EQ(status.message.find("name = " + std::string(name) + ": expected "), 0u);
  }
}

}  // namespace
}  // namespace rovio_sfm
