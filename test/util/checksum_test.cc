#include "rovio_sfm/util/checksum.h"

#include <gtest/gtest.h>

#include <string>

namespace rovio_sfm {
namespace {

uint32_t ChecksumOf(const std::string& text) {
  return Checksum(reinterpret_cast<const uint8_t*>(text.data()), text.size());
}

TEST(Checksum, IsTheCrc32ThatOthersCompute) {
  EXPECT_EQ(ChecksumOf(""), 0u);
  EXPECT_EQ(ChecksumOf("123456789"), 0xCBF43926u);  // the check value of CRC-32/ISO-HDLC
}

}  // namespace
}  // namespace rovio_sfm
