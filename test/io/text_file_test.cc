#include "rovio_sfm/io/text_file.h"

#include <unistd.h>

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

TEST(StampFromDecimal, ReadsWhatNumpyWrites) {
  EXPECT_EQ(StampFromDecimal("1.305031102175303936e+09"), 1305031102175303936);
  EXPECT_EQ(StampFromDecimal("0.000000000000000000e+00"), 0);
  EXPECT_EQ(StampFromDecimal("+1.5E2"), 150000000000);
  EXPECT_EQ(StampFromDecimal("12.5e-3"), 12500000);
  EXPECT_EQ(StampFromDecimal("5e-9"), 5);
}

TEST(StampFromDecimal, TellsNanosecondsFromSeconds) {
  EXPECT_EQ(StampFromDecimal("1403636579763555584"), 1403636579763555584);
  EXPECT_EQ(StampFromDecimal("1.403636579763555584e+18"), 1403636579763555584);
  EXPECT_EQ(StampFromDecimal("0001403636579"), 1403636579000000000);
}

TEST(StampFromDecimal, RefusesWhatIsNoDecimal) {
  for (const char* text :
       {"", ".", "-", "1e99", "1e", "e5", "1e5.0", "1.2.3", "abc", "nan", "99999999999",
        "1305031102175", "1305031102175304", "99999999999999999999", "1.-5"}) {
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

TEST(ReadTextFile, PassesOverAByteOrderMark) {
  const TemporaryFolder folder;
  const auto lines = ReadTextFile(folder.Write("a.txt",
                                               "\xEF\xBB\xBF"
                                               "1 two words \r\n"));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].Number(0, "one"), 1.0);
  EXPECT_EQ(lines[0].From(1), "two words");
  const auto wide = folder.Write("b.txt", std::string("\xFF\xFE"
                                                      "1\0\n\0",
                                                      6));
  EXPECT_NE(MessageOf([&] { ReadTextFile(wide); }).find("UTF-16"), std::string::npos);
}

TEST(TextLine, ReadsSignsAndExponents) {
  const TemporaryFolder folder;
  const auto lines = ReadTextFile(folder.Write("a.txt", "+1.5 -2.5e+01 1e-3 +-1\n"));
  EXPECT_EQ(lines[0].Number(0, "a"), 1.5);
  EXPECT_EQ(lines[0].Number(1, "b"), -25.0);
  EXPECT_EQ(lines[0].Number(2, "c"), 1e-3);
  EXPECT_THROW(lines[0].Number(3, "d"), std::runtime_error);
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
  EXPECT_EQ(MessageOf([&] { ReadBytes(path, 4); }), path.string() + ": 5 bytes, more than 4");
}

// A pipe that holds a text; its reading end goes with the object.
class Pipe {
 public:
  explicit Pipe(const std::string& text) {
    int ends[2] = {-1, -1};
    if (pipe(ends) != 0) ADD_FAILURE() << "no pipe";
    reading_end_ = ends[0];
    EXPECT_EQ(write(ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
    close(ends[1]);
  }
  ~Pipe() { close(reading_end_); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  std::string Path() const { return "/dev/fd/" + std::to_string(reading_end_); }

 private:
  int reading_end_ = -1;
};

TEST(ReadBytes, ReadsPipesToTheirEnd) {
  EXPECT_EQ(ReadBytes(Pipe("12345").Path(), 5).size(), 5u);
  EXPECT_TRUE(ReadBytes(Pipe("").Path(), 5).empty());
  EXPECT_EQ(ReadTextFile(Pipe("# a\n1 2\n").Path()).at(0).fields.at(1), "2");
}

TEST(ReadBytes, BoundsWhatHasNoSize) {
  const Pipe pipe("12345");
  EXPECT_EQ(MessageOf([&] { ReadBytes(pipe.Path(), 4); }), pipe.Path() + ": more bytes than 4");
  EXPECT_EQ(MessageOf([&] { ReadBytes("/dev/zero", 9); }), "/dev/zero: more bytes than 9");
}

TEST(ReadBytes, RefusesFoldersAndWhatIsNotThere) {
  const TemporaryFolder folder;
  const std::string path = folder.Path().string();
  EXPECT_EQ(MessageOf([&] { ReadBytes(path, 4); }), path + ": Is a directory");
  EXPECT_EQ(MessageOf([&] { ReadBytes(path + "/a", 4); }), path + "/a: No such file or directory");
}

}  // namespace
}  // namespace rovio_sfm
