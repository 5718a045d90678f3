#include "rovio_sfm/io/map_store_schema.h"

#include <gtest/gtest.h>

#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

class MapStoreSchema : public ::testing::Test {
 protected:
  void Make(const std::string& script) {
    StoreDatabase(file_, StoreAccess::kCreate).Execute(script);
  }
  std::string ErrorOf(StoreAccess access) {
    return MessageOf([&] {
      StoreDatabase database(file_, access);
      OpenSchema(access, &database);
    });
  }

  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.Path() / "map.db";
};

TEST_F(MapStoreSchema, IsMadeOnceAndOpenedThen) {
  for (const auto access :
       {StoreAccess::kCreate, StoreAccess::kCreate, StoreAccess::kWrite, StoreAccess::kRead}) {
    EXPECT_EQ(ErrorOf(access), "");
  }
  StoreDatabase database(file_, StoreAccess::kWrite);
  OpenSchema(StoreAccess::kWrite, &database);
  for (const auto& [pragma, expected] :
       {std::pair("PRAGMA journal_mode", "wal"), std::pair("PRAGMA synchronous", "3"),
        std::pair("PRAGMA foreign_keys", "1"), std::pair("PRAGMA user_version", "2"),
        std::pair("PRAGMA integrity_check", "ok")}) {
    Rows rows = database.Query(pragma);
    ASSERT_TRUE(rows.Next());
    EXPECT_EQ(rows.Text(0), expected) << pragma;
  }
}

TEST_F(MapStoreSchema, LeavesAnotherProgramsFileAsItWas) {
  Make("CREATE TABLE notes (text)");
  const std::string before = ReadText(file_);
  for (const auto access : {StoreAccess::kCreate, StoreAccess::kWrite, StoreAccess::kRead}) {
    EXPECT_EQ(ErrorOf(access), file_.string() + ": not a map store of rovio_sfm");
  }
  EXPECT_EQ(ReadText(file_), before);
}

TEST_F(MapStoreSchema, RefusesAnEmptyFileThatShouldHoldMaps) {
  folder_.Write("map.db", "");
  EXPECT_EQ(ErrorOf(StoreAccess::kWrite), file_.string() + ": not a map store of rovio_sfm");
  EXPECT_EQ(ErrorOf(StoreAccess::kRead), file_.string() + ": not a map store of rovio_sfm");
  EXPECT_EQ(ErrorOf(StoreAccess::kCreate), "");
}

TEST_F(MapStoreSchema, RefusesOlderAndNewerVersionsWithBothNamed) {
  ASSERT_EQ(ErrorOf(StoreAccess::kCreate), "");
  for (const int version : {0, kStoreVersion + 1, -1}) {
    Make("PRAGMA user_version = " + std::to_string(version));
    const std::string before = ReadText(file_);
    for (const auto access : {StoreAccess::kCreate, StoreAccess::kWrite, StoreAccess::kRead}) {
      EXPECT_EQ(ErrorOf(access), file_.string() + ": version = " + std::to_string(version) +
                                     ": expected " + std::to_string(kStoreVersion) +
                                     ", which this program writes, or 1");
    }
    EXPECT_EQ(ReadText(file_), before);
  }
}

TEST_F(MapStoreSchema, ReadsVersionOneAsItIsAndRaisesItToWrite) {
  ASSERT_EQ(ErrorOf(StoreAccess::kCreate), "");
  Make("DROP TABLE session_camera; PRAGMA user_version = 1; PRAGMA wal_checkpoint(TRUNCATE)");
  const auto cameras = [&](StoreAccess access) {
    StoreDatabase database(file_, access);
    OpenSchema(access, &database);
    Rows rows = database.Query("SELECT count(*) FROM session_camera");
    return rows.Next() ? rows.Int(0) : -1;
  };
  const auto version = [&] {
    StoreDatabase database(file_, StoreAccess::kRead);
    Rows rows = database.Query("PRAGMA user_version");
    return rows.Next() ? rows.Int(0) : -1;
  };
  const std::string before = ReadText(file_);
  EXPECT_EQ(cameras(StoreAccess::kRead), 0);
  EXPECT_EQ(ReadText(file_), before);
  EXPECT_EQ(version(), 1);
  EXPECT_EQ(cameras(StoreAccess::kWrite), 0);
  EXPECT_EQ(version(), 2);
  EXPECT_EQ(cameras(StoreAccess::kRead), 0);
}

std::string Page() {
  return ReadText(std::filesystem::path(ROVIO_SOURCE_DIR) / "docs/map_store.md");
}

TEST_F(MapStoreSchema, IsDescribedToTheLastColumn) {
  ASSERT_EQ(ErrorOf(StoreAccess::kCreate), "");
  StoreDatabase database(file_, StoreAccess::kRead);
  Rows columns = database.Query(
      "SELECT t.name, c.name FROM sqlite_master t JOIN pragma_table_info(t.name) c "
      "WHERE t.type = 'table'");
  const std::string page = Page();
  size_t num_columns = 0;
  for (; columns.Next(); ++num_columns) {
    const size_t row = page.find("\n| `" + columns.Text(0) + "` |");
    ASSERT_NE(row, std::string::npos) << columns.Text(0);
    const std::string line = page.substr(row + 1, page.find('\n', row + 1) - row);
    EXPECT_NE(line.find("`" + columns.Text(1) + "`"), std::string::npos)
        << columns.Text(0) << "." << columns.Text(1);
  }
  EXPECT_GT(num_columns, 80u);
  const std::string version = "## Schema, version " + std::to_string(kStoreVersion) + "\n";
  EXPECT_NE(page.find(version), std::string::npos);
}

TEST_F(MapStoreSchema, IsLookedAtByTheQueriesOfThePage) {
  ASSERT_EQ(ErrorOf(StoreAccess::kCreate), "");
  StoreDatabase database(file_, StoreAccess::kRead);
  const std::string page = Page(), begin = "```sql\n", end = "```";
  size_t num_queries = 0;
  for (size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1)) {
    const size_t first = at + begin.size();
    const std::string query = page.substr(first, page.find(end, first) - first);
    EXPECT_EQ(MessageOf([&] { database.Run(query.c_str()); }), "") << query;
    ++num_queries;
  }
  EXPECT_EQ(num_queries, 6u);
}

}  // namespace
}  // namespace rovio_sfm
