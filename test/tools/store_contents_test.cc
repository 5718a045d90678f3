#include "rovio_sfm/tools/store_contents.h"

#include <gtest/gtest.h>

#include <sstream>

#include "tools/kept_maps.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

class StoreContents : public ::testing::Test {
 protected:
  void SetUp() override { KeepTwoDrives(file_, true); }
  std::string FaultsAfter(const std::string& change) {
    Spoil(file_, change);
    std::string all;
    for (const std::string& fault : FindStoreFaults(file_)) all += fault + "\n";
    return all;
  }
  int64_t Count(const std::string& table) {
    StoreDatabase database(file_, StoreAccess::kRead);
    Rows rows = database.Query(("SELECT count(*) FROM " + table).c_str());
    rows.Next();
    return rows.Int(0);
  }

  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.Path() / "map.db";
};

TEST_F(StoreContents, AreToldForPeople) {
  std::ostringstream out;
  TellContents(file_, out);
  const std::string text = out.str();
  for (const char* expected :
       {"map.db: map store, version 2, ", "drives    2\n", ": 12 frames, of them 12 keyframes",
        "goes on at 12\n", "sessions  2\n", "  1: map 1, drive ", ", 12 posed frames, ",
        "maps      1\n  1: sessions 1, 2\n",
        "overlaps  1\n  1: merge of sessions 1 and 2, accepted", "images      24 rows, 2.3 KiB\n",
        "descriptors 24 rows"}) {
    EXPECT_NE(text.find(expected), std::string::npos) << expected << " in\n" << text;
  }
}

// Nor does summary.json count one.
TEST_F(StoreContents, ASessionThatNeverBeganIsNoMap) {
  const std::filesystem::path apart = folder_.Path() / "apart.db";
  KeepTwoDrives(apart, false);
  Spoil(apart,
        "DELETE FROM keyframe WHERE session = 2; DELETE FROM keyframe_tracks WHERE session = 2;"
        "DELETE FROM landmark_block WHERE session = 2");
  std::ostringstream out;
  TellContents(apart, out);
  const std::string text = out.str();
  EXPECT_NE(text.find("  2: map 2, drive "), std::string::npos) << text;
  EXPECT_NE(text.find("maps      1\n  1: sessions 1\noverlaps"), std::string::npos) << text;
}

TEST_F(StoreContents, OfASoundStoreHaveNoFaults) { EXPECT_EQ(FaultsAfter(""), ""); }

TEST_F(StoreContents, FaultsAreNamedEachByItself) {
  const std::string faults = FaultsAfter(
      "UPDATE frame SET tracks = x'00' WHERE number = 3 AND drive = 1;"
      "UPDATE pair SET verdict = 7 WHERE frame = (SELECT max(id) FROM frame);"
      "UPDATE keyframe SET pose = x'00' WHERE session = 2;"
      "INSERT INTO gauge (map, revision) VALUES (9, 9);"
      "INSERT INTO image (frame, jpeg) VALUES (5, x'00')");
  for (const char* expected :
       {"stray row of: image\n", "/3: ", "tracks: 1 bytes too many", "pair.verdict = 7",
        "session 1: tracks: 1 bytes too many", "session 2: frame 0: pose: cut short"}) {
    EXPECT_NE(faults.find(expected), std::string::npos) << expected << " in\n" << faults;
  }
}

// What no map can hold, though it reads.
TEST_F(StoreContents, FaultsAreNumbersThatNoPoseHas) {
  const std::string no_turn = "000000000000000000000000000000000000000000000000000000000000F03F";
  const std::string nan = "000000000000F87F", huge = "9C7500883CE4377E", zero = "0000000000000000";
  const auto spoilt = [&](const std::string& pose) {
    return FaultsAfter("UPDATE keyframe SET pose = x'" + pose + "' WHERE session = 2");
  };
  for (const std::string& number : {nan, huge}) {
    const std::string faults = spoilt(no_turn + zero + number + zero);
    EXPECT_NE(faults.find("session 2: frame 0: pose: translation = "), std::string::npos) << faults;
  }
  const std::string faults = spoilt(zero + zero + zero + zero + zero + zero + zero);
  EXPECT_NE(faults.find("frame 0: pose: rotation: a quaternion of length 0"), std::string::npos)
      << faults;
  EXPECT_EQ(spoilt(no_turn + zero + zero + zero), "");
}

TEST_F(StoreContents, ArePrunedOfWhatWasChosen) {
  PruneChoice choice;
  choice.images = true;
  choice.drives = {MapsIn(file_)->sessions[0].drive.ToString()};
  EXPECT_EQ(PruneStore(file_, choice).num_rows, 12u);
  EXPECT_EQ(Count("image"), 12);
  choice.drives.clear();
  choice.descriptors = true;
  EXPECT_EQ(PruneStore(file_, choice).num_rows, 36u);
  EXPECT_EQ(Count("image") + Count("descriptors"), 0);
  EXPECT_TRUE(FindStoreFaults(file_).empty());
  EXPECT_EQ(MapsIn(file_)->sessions.size(), 2u);
  choice.drives = {"nobody"};
  EXPECT_EQ(MessageOf([&] { PruneStore(file_, choice); }),
            "drive = nobody: expected one that the store holds");
}

}  // namespace
}  // namespace rovio_sfm
