#include "rovio_sfm/util/base64.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

std::string Encode(const std::string& text) { return Base64({text.begin(), text.end()}); }

TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(Encode(""), "");
  EXPECT_EQ(Encode("f"), "Zg==");
  EXPECT_EQ(Encode("fo"), "Zm8=");
  EXPECT_EQ(Encode("foo"), "Zm9v");
  EXPECT_EQ(Encode("foobar"), "Zm9vYmFy");
  EXPECT_EQ(Encode("\xfb\xff"), "+/8=");
}

TEST(Base64Of, TakesNumbersAsTheyLieInMemory) {
  EXPECT_EQ(Base64Of(std::vector<float>{1.0f}), "AACAPw==");
  EXPECT_EQ(Base64Of(std::vector<float>{}), "");
}

}  // namespace
}  // namespace rovio_sfm
