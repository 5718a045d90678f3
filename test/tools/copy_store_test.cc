#include "rovio_sfm/tools/copy_store.h"

#include <gtest/gtest.h>

#include "tools/kept_maps.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

class CopyStore : public ::testing::Test {
 protected:
  // All rows of the tables that say what a store holds; how a journal was written in parts does
  // not count.
  static std::string ContentOf(const std::filesystem::path& file) {
    StoreDatabase database(file, StoreAccess::kRead);
    std::string content;
    for (const char* text :
         {"SELECT * FROM info ORDER BY 1", "SELECT * FROM drive ORDER BY 1",
          "SELECT * FROM frame ORDER BY 1", "SELECT * FROM descriptors ORDER BY 1",
          "SELECT * FROM image ORDER BY 1", "SELECT * FROM pair ORDER BY 1, 2",
          "SELECT * FROM track_link ORDER BY 1, 2", "SELECT * FROM session ORDER BY 1",
          "SELECT * FROM keyframe ORDER BY 1, 2", "SELECT * FROM keyframe_tracks ORDER BY 1, 2",
          "SELECT * FROM light_pose ORDER BY 1, 2", "SELECT * FROM landmark_block ORDER BY 1, 2",
          "SELECT * FROM track_alias ORDER BY 1, 2", "SELECT * FROM merge_edit ORDER BY 1",
          "SELECT * FROM waiting_match ORDER BY 1", "SELECT * FROM gauge ORDER BY 1",
          "SELECT * FROM separated ORDER BY 1, 2"}) {
      content += TextOf(text, &database);
    }
    return content;
  }
  static std::string TextOf(const std::string& text, StoreDatabase* database) {
    std::string all = text;
    Rows columns = database->Query(("SELECT count(*) FROM pragma_table_info('" +
                                    text.substr(14, text.find(' ', 14) - 14) + "')")
                                       .c_str());
    columns.Next();
    Rows rows = database->Query(text.c_str());
    while (rows.Next()) {
      for (int i = 0; i < columns.Int(0); ++i) {
        const Blob value = rows.Bytes(i);
        all += "|" + std::string(static_cast<const char*>(value.data), value.size);
      }
    }
    return all;
  }

  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.Path() / "map.db", new_ = folder_.Path() / "new.db";
};

TEST_F(CopyStore, KeepsEverythingOfASoundStore) {
  KeepTwoDrives(file_, true);
  const StoreCopyReport report = RepairStore(file_, new_);
  EXPECT_TRUE(report.lost.empty());
  EXPECT_EQ(report.num_frames, 24u);
  EXPECT_EQ(report.num_sessions, 2u);
  EXPECT_EQ(report.num_edits, 1u);
  EXPECT_EQ(ContentOf(new_), ContentOf(file_));
  EXPECT_EQ(BytesOf(*MapsIn(new_)), BytesOf(*MapsIn(file_)));
  EXPECT_NE(MessageOf([&] { RepairStore(file_, new_); }).find("new.db: not overwritten"),
            std::string::npos);
}

TEST_F(CopyStore, LeavesOutTheSessionThatDoesNotReadAndUndoesItsMerges) {
  KeepTwoDrives(file_, true);
  Spoil(file_, "UPDATE landmark_block SET landmarks = x'00' WHERE session = 2");
  EXPECT_NE(MessageOf([&] { MapsIn(file_); }).find("session 2: landmarks: cut short"),
            std::string::npos);
  const StoreCopyReport report = RepairStore(file_, new_);
  ASSERT_EQ(report.lost.size(), 1u);
  EXPECT_NE(report.lost[0].find("session 2: landmarks: cut short"), std::string::npos);
  EXPECT_EQ(report.num_frames, 24u);
  const auto maps = MapsIn(new_);
  EXPECT_EQ(maps->sessions.at(0).id.value, 1u);
  MapStore store(new_, StoreAccess::kRead);
  const MergeRecord merges = store.Read(DefaultFrameMaker()).merges;
  ASSERT_EQ(merges.edits.size(), 1u);
  EXPECT_EQ(merges.edits[0].report.verdict, MergeVerdict::kUndone);
}

TEST_F(CopyStore, KeepsTheOtherFramesWhereOneDoesNotRead) {
  KeepTwoDrives(file_, true);
  Spoil(file_, "UPDATE frame SET keypoints = x'00' WHERE number = 5 AND drive = 1");
  const StoreCopyReport report = RepairStore(file_, new_);
  EXPECT_EQ(report.lost.size(), 2u);  // the frame, and the session that needs it
  EXPECT_EQ(report.num_frames, 23u);
  EXPECT_EQ(report.num_sessions, 1u);
}

TEST_F(CopyStore, PutsTwoStoresIntoOne) {
  const std::filesystem::path second = folder_.Path() / "second.db";
  KeepTwoDrives(file_, true);
  KeepTwoDrives(second, true, "other_");
  const StoreCopyReport report = MergeStores(file_, second, new_);
  EXPECT_EQ(report.num_frames, 48u);
  EXPECT_EQ(report.num_edits, 2u);
  const auto a = MapsIn(file_), b = MapsIn(second), both = MapsIn(new_);
  ASSERT_EQ(both->sessions.size(), a->sessions.size() + b->sessions.size());
  for (size_t i = 0; i < both->sessions.size(); ++i) {
    const bool of_a = i < a->sessions.size();
    const SessionSnapshot& was = of_a ? a->sessions[i] : b->sessions[i - a->sessions.size()];
    const SessionSnapshot& now = both->sessions[i];
    const uint32_t shift = of_a ? 0 : a->sessions.back().id.value;
    EXPECT_EQ(now.id.value, was.id.value + shift);
    EXPECT_EQ(now.map.value, was.map.value + shift);
    EXPECT_EQ(now.gauge_revision, was.gauge_revision);
    EXPECT_EQ(now.drive, was.drive);
    MapSnapshot one_now, one_was;
    one_now.sessions = {now};
    one_was.sessions = {was};
    one_now.sessions[0].id = one_was.sessions[0].id;
    EXPECT_EQ(BytesOf(one_now), BytesOf(one_was));
  }
}

// A merge of the second store is undone as it would have been there.
TEST_F(CopyStore, MergesOfBothStoresCanBeUndone) {
  const std::filesystem::path second = folder_.Path() / "second.db";
  KeepTwoDrives(file_, true);
  KeepTwoDrives(second, true, "other_");
  MergeStores(file_, second, new_);
  MapStore store(new_, StoreAccess::kWrite);
  Executor executor{0};
  Mapper mapper({}, &store, &executor);
  mapper.Restore(&store);
  const SessionId last = mapper.Snapshot()->sessions.back().id;
  ASSERT_EQ(mapper.Unmerge(last).size(), 1u);
  const auto maps = mapper.Snapshot();
  EXPECT_EQ(maps->sessions[0].map, maps->sessions[1].map);
  EXPECT_FALSE(maps->sessions[2].map == maps->sessions[3].map);
}

TEST_F(CopyStore, RefusesTwoStoresThatHoldOneDrive) {
  KeepTwoDrives(file_, false);
  EXPECT_NE(MessageOf([&] { MergeStores(file_, file_, new_); }).find("both hold frames of drive"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(new_));
}

}  // namespace
}  // namespace rovio_sfm
