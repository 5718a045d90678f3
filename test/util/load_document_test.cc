#include "rovio_sfm/util/load_document.h"

#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

TEST(LoadDocument, TakesOneDocument) {
  EXPECT_EQ(LoadDocument("a: 1\n---\n")["a"].as<int>(), 1);
  EXPECT_FALSE(LoadDocument("").IsMap());
  const std::string message = MessageOf([] { LoadDocument("a: 1\n---\na: 2\n"); });
  EXPECT_NE(message.find("line 3"), std::string::npos) << message;
  EXPECT_NE(message.find("a second document: expected one"), std::string::npos) << message;
}

TEST(IsDecimal, TakesWhatPeopleWrite) {
  for (const char* text : {"0", "7", "-12", "+12", "100"}) EXPECT_TRUE(IsDecimal(text)) << text;
  for (const char* text : {"", "-", "0777", "-01", "0x10", "1.5", "1e3", " 1", "1 "}) {
    EXPECT_FALSE(IsDecimal(text)) << text;
  }
}

}  // namespace
}  // namespace rovio_sfm
