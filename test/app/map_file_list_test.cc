#include "rovio_sfm/app/map_file_list.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

namespace fs = std::filesystem;

class MapFileListTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(out_ / "a/b");
    folder_.Write("outside.txt", "mine");
    for (const char* name : {"out/one.txt", "out/a/b/two.txt", "out/mine.txt"}) {
      folder_.Write(name, "x");
    }
  }
  std::string List() const {
    std::ostringstream text;
    text << std::ifstream(out_ / kMapFileList).rdbuf();
    return text.str();
  }

  const TemporaryFolder folder_;
  const fs::path out_ = folder_.Path() / "out";
};

TEST_F(MapFileListTest, HoldsRelativeNamesOnceInOrder) {
  AddListedFiles(out_, {out_ / "one.txt"});
  AddListedFiles(out_, {out_ / "one.txt", out_ / "a/b/two.txt"});
  EXPECT_NE(List().find("again.\na/b/two.txt\none.txt\n"), std::string::npos) << List();
  EXPECT_EQ(ListedFiles(out_).size(), 2u);
  EXPECT_TRUE(ListedFiles(folder_.Path() / "nowhere").empty());
}

TEST_F(MapFileListTest, RemovesWhatIsListedAndNotFreshWithEmptyFolders) {
  AddListedFiles(out_, {out_ / "one.txt", out_ / "a/b/two.txt"});
  RemoveListedBut(out_, {out_ / "one.txt"});
  EXPECT_FALSE(fs::exists(out_ / "a"));
  EXPECT_TRUE(fs::exists(out_ / "one.txt"));
  EXPECT_TRUE(fs::exists(out_ / "mine.txt"));
  RemoveListedBut(out_, {});
  EXPECT_FALSE(fs::exists(out_ / "one.txt"));
  EXPECT_FALSE(fs::exists(out_ / kMapFileList));
  EXPECT_TRUE(fs::exists(out_ / "mine.txt"));
}

// A list is a file that anybody may have written.
TEST_F(MapFileListTest, NeverLeadsOutOfItsFolder) {
  fs::create_directory_symlink(folder_.Path(), out_ / "link");
  folder_.Write("out/map_files.txt", "../outside.txt\n" +
                                         (folder_.Path() / "outside.txt").string() +
                                         "\nlink/outside.txt\n.\n..\na/../../outside.txt\n");
  EXPECT_TRUE(ListedFiles(out_).empty());
  RemoveListedBut(out_, {});
  EXPECT_TRUE(fs::exists(folder_.Path() / "outside.txt"));
}

}  // namespace
}  // namespace rovio_sfm
