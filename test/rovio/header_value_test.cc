#include "rovio_sfm/rovio/header_value.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(HeaderValue, FindsTheValueLetterCaseAside) {
  EXPECT_EQ(HeaderValue("content-TYPE:  image/jpeg \r\n", "Content-Type"), "image/jpeg");
  EXPECT_EQ(HeaderValue("Content-Type: a:b", "Content-Type"), "a:b");
  EXPECT_EQ(HeaderValue("X-Content-Type: a", "Content-Type"), std::nullopt);
  EXPECT_EQ(HeaderValue("no colon", "no colon"), std::nullopt);
}

TEST(ParseContentLength, TakesDigitsOnly) {
  EXPECT_EQ(ParseContentLength("0"), 0u);
  EXPECT_EQ(ParseContentLength("65536"), 65536u);
  for (const char* const bad : {"", "-1", "+1", "0x10", "1 2", "99999999999999999999999"}) {
    EXPECT_EQ(ParseContentLength(bad), std::nullopt) << bad;
  }
}

TEST(Trim, TakesBlanksAndLineEndsOffBothEnds) {
  EXPECT_EQ(Trim(" \r\n a b\t\n"), "a b");
  EXPECT_EQ(Trim(" \r\n"), "");
}

}  // namespace
}  // namespace rovio_sfm
