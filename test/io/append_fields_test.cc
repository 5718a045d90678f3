#include "rovio_sfm/io/append_fields.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(AppendFields, PutsSpacesBetweenTheFieldsOfALine) {
  std::string text = "# head\n";
  AppendFields(&text, 1, 0.1, -2.5f);
  AppendFields(&text, 4u);
  EXPECT_EQ(text, "# head\n1 0.1 -2.5 4");
}

TEST(AppendFields, WritesWhatReadsBackAsTheSameNumber) {
  for (const double value : {1.0 / 3.0, 1e-300, -1.7976931348623157e308}) {
    std::string text;
    AppendFields(&text, value);
    EXPECT_EQ(std::stod(text), value) << text;
  }
}

TEST(AppendBytes, IsLittleEndian) {
  std::string bytes;
  AppendBytes(uint32_t{0x01020304}, &bytes);
  EXPECT_EQ(bytes, std::string("\x04\x03\x02\x01"));
}

}  // namespace
}  // namespace rovio_sfm
