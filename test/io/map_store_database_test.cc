#include "rovio_sfm/io/map_store_database.h"

#include <gtest/gtest.h>

#include <limits>

#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

class MapStoreDatabase : public ::testing::Test {
 protected:
  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.Path() / "a.db";
};

TEST_F(MapStoreDatabase, GivesBackEveryTypeAsItWas) {
  StoreDatabase database(file_, StoreAccess::kCreate);
  database.Execute("CREATE TABLE t (id INTEGER PRIMARY KEY, v)");
  const std::string text("nul \0 within", 12), bytes("\0\1\2", 3);
  const int64_t least = std::numeric_limits<int64_t>::min();
  const uint64_t big = std::numeric_limits<uint64_t>::max();
  const uint32_t number = std::numeric_limits<uint32_t>::max();
  const std::optional<double> none;
  const std::optional<std::string> some = "some";
  database.Run("INSERT INTO t (v) VALUES (?), (?), (?), (?), (?), (?), (?), (?)", least, big,
               number, 0.1, text, BlobOf(bytes), none, some);
  EXPECT_EQ(database.LastId(), 8);
  Rows rows = database.Query("SELECT v FROM t ORDER BY id");
  ASSERT_TRUE(rows.Next());
  EXPECT_EQ(rows.Int(0), least);
  ASSERT_TRUE(rows.Next());
  EXPECT_EQ(static_cast<uint64_t>(rows.Int(0)), big);
  ASSERT_TRUE(rows.Next());
  EXPECT_EQ(rows.Int(0), int64_t{number});
  ASSERT_TRUE(rows.Next());
  EXPECT_EQ(rows.Double(0), 0.1);
  ASSERT_TRUE(rows.Next());
  EXPECT_EQ(rows.Text(0), text);
  ASSERT_TRUE(rows.Next());
  const Blob blob = rows.Bytes(0);
  EXPECT_EQ(std::string(static_cast<const char*>(blob.data), blob.size), bytes);
  ASSERT_TRUE(rows.Next());
  EXPECT_TRUE(rows.IsNull(0));
  ASSERT_TRUE(rows.Next());
  EXPECT_EQ(rows.Text(0), "some");
  EXPECT_FALSE(rows.Next());
}

TEST_F(MapStoreDatabase, AQueryStartsAnewWithOtherValues) {
  StoreDatabase database(file_, StoreAccess::kCreate);
  for (int i = 0; i < 3; ++i) {
    Rows rows = database.Query("SELECT ?", i);
    ASSERT_TRUE(rows.Next());
    EXPECT_EQ(rows.Int(0), i);
  }
}

TEST_F(MapStoreDatabase, NamesFileAndCauseWhereItCannotBeOpened) {
  const std::string missing =
      MessageOf([&] { StoreDatabase database(file_, StoreAccess::kWrite); });
  EXPECT_EQ(missing, file_.string() + ": cannot be opened: no such file");
  EXPECT_FALSE(std::filesystem::exists(file_));
  const std::string vfs =
      MessageOf([&] { StoreDatabase(file_, StoreAccess::kCreate, "nonsense"); });
  EXPECT_NE(vfs.find("no such vfs: nonsense"), std::string::npos) << vfs;
}

TEST_F(MapStoreDatabase, NamesFileAndCauseOfAFailedStatement) {
  folder_.Write("a.db",
                "this is no database, but long enough to have a header of one, and more "
                "than a hundred bytes of text that nobody asked for");
  StoreDatabase text(file_, StoreAccess::kWrite);
  EXPECT_EQ(MessageOf([&] { text.Run("SELECT * FROM sqlite_master"); }),
            file_.string() + ": file is not a database (SQLite 26)");
  StoreDatabase database(folder_.Path() / "b.db", StoreAccess::kCreate);
  EXPECT_NE(MessageOf([&] { database.Run("SELECT nonsense"); }).find("b.db: no such column"),
            std::string::npos);
  database.Execute("CREATE TABLE t (v INTEGER NOT NULL) STRICT");
  EXPECT_NE(MessageOf([&] {
              database.Run("INSERT INTO t VALUES (?)", std::string("text"));
            }).find("b.db: cannot store TEXT value in INTEGER column t.v"),
            std::string::npos);
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(MessageOf([&] { database.Run("INSERT INTO t VALUES (?)", no_number); }).find("t.v"),
            std::string::npos);
}

TEST_F(MapStoreDatabase, TakesBackATransaction) {
  StoreDatabase database(file_, StoreAccess::kCreate);
  database.Execute("CREATE TABLE t (v); BEGIN; INSERT INTO t VALUES (1)");
  EXPECT_TRUE(database.IsInTransaction());
  database.RollBack();
  EXPECT_FALSE(database.IsInTransaction());
  database.RollBack();  // nothing is open
  Rows rows = database.Query("SELECT count(*) FROM t");
  ASSERT_TRUE(rows.Next());
  EXPECT_EQ(rows.Int(0), 0);
}

TEST_F(MapStoreDatabase, RefusesAValueThatIsNotOfAnEnum) {
  StoreDatabase database(file_, StoreAccess::kCreate);
  enum class Kind { kA, kB };
  for (const int value : {-1, 2}) {
    Rows rows = database.Query("SELECT ?", value);
    ASSERT_TRUE(rows.Next());
    EXPECT_EQ(MessageOf([&] { ReadEnum(rows, 0, Kind::kB, "t.kind"); }),
              "t.kind = " + std::to_string(value) + ": expected 0 to 1");
  }
  Rows rows = database.Query("SELECT ?", 1);
  ASSERT_TRUE(rows.Next());
  EXPECT_EQ(ReadEnum(rows, 0, Kind::kB, "t.kind"), Kind::kB);
}

TEST(WithFileNamed, NamesTheFileOnce) {
  const auto fail = [](const std::string& what) {
    return MessageOf(
        [&] { WithFileNamed("a.db", [&]() -> int { throw std::runtime_error(what); }); });
  };
  EXPECT_EQ(fail("pose: cut short"), "a.db: pose: cut short");
  EXPECT_EQ(fail("a.db: pose: cut short"), "a.db: pose: cut short");
  const auto fail_within = [&]() -> int { throw std::runtime_error("a.db: pose: cut short"); };
  EXPECT_EQ(MessageOf([&] { WithFileNamed("a.db", fail_within, "session 1: "); }),
            "a.db: session 1: pose: cut short");
}

}  // namespace
}  // namespace rovio_sfm
