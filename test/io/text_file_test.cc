#include "rovio_sfm/io/text_file.h"

#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

TEST(StampFromDecimal, IsExactWhereDoublesAreNot) {
  EXPECT_EQ(StampFromDecimal("1305031102.175304"), 1305031102175304000);
  EXPECT_EQ(StampFromDecimal("1305031102.123456789"), 1305031102123456789);
  EXPECT_EQ(StampFromDecimal("0.000000"), 0);
  EXPECT_EQ(StampFromDecimal("7"), 7000000000);
  EXPECT_EQ(StampFromDecimal("-1.5"), -1500000000);
}

TEST(StampFromDecimal, RefusesWhatIsNoDecimal) {
  for (const char* text : {"", ".", "-", "1e5", "1.2.3", "abc", "nan", "99999999999", "1.-5"}) {
    EXPECT_FALSE(StampFromDecimal(text).has_value()) << text;
  }
}

TEST(DecimalFromStamp, RoundTrips) {
  for (const int64_t stamp :
       {0L, 1305031102175304000L, 1305031102175304001L, -1500000000L, 5000L}) {
    EXPECT_EQ(StampFromDecimal(DecimalFromStamp(stamp)), stamp);
  }
  EXPECT_EQ(DecimalFromStamp(1305031102175304000), "1305031102.175304");
}

TEST(ReadTextFile, SkipsCommentsAndKeepsLineNumbers) {
  const TemporaryFolder folder;
  const auto lines = ReadTextFile(folder.Write("a.txt", "# head\n\n1 2\n  # more\n3\r\n"));
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].number, 3);
  EXPECT_EQ(lines[0].fields, (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(lines[1].number, 5);
}

TEST(ReadTextFile, SaysWhichFileIsMissing) {
  EXPECT_NE(MessageOf([] { ReadTextFile("absent.txt"); }).find("absent.txt"), std::string::npos);
}

TEST(ReadTextFile, RefusesEndlessLines) {
  const TemporaryFolder folder;
  const auto path = folder.Write("a.txt", std::string(5000, '1'));
  EXPECT_NE(MessageOf([&] { ReadTextFile(path); }).find("4096"), std::string::npos);
}

TEST(TextLine, NamesFileLineAndField) {
  const TextLine line{"f.txt", 7, {"1.5", "nan", "x", "0"}};
  EXPECT_EQ(line.Number(0, "fx"), 1.5);
  const std::string message = MessageOf([&] { line.Number(2, "fy"); });
  EXPECT_NE(message.find("f.txt:7"), std::string::npos) << message;
  EXPECT_NE(message.find("fy"), std::string::npos) << message;
  EXPECT_NE(MessageOf([&] { line.Number(1, "fy"); }), "");
  EXPECT_NE(MessageOf([&] { line.PositiveInteger(3, "width"); }), "");
  EXPECT_NE(MessageOf([&] { line.PositiveInteger(0, "width"); }), "");
  EXPECT_NE(MessageOf([&] { line.RequireFields(3, "a b c"); }), "");
}

TEST(ReadBytes, RefusesLargeFiles) {
  const TemporaryFolder folder;
  const auto path = folder.Write("a.bin", "12345");
  EXPECT_EQ(ReadBytes(path, 5).size(), 5u);
  EXPECT_NE(MessageOf([&] { ReadBytes(path, 4); }), "");
}

}  // namespace
}  // namespace rovio_sfm
