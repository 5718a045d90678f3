#include "rovio_sfm/util/count_text.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(CountText, SaysOneAndMany) {
  EXPECT_EQ(CountText(0, "image"), "0 images");
  EXPECT_EQ(CountText(1, "image"), "1 image");
  EXPECT_EQ(CountText(2, "image"), "2 images");
  EXPECT_EQ(CountWere(1, "picture"), "1 picture was");
  EXPECT_EQ(CountWere(3, "picture"), "3 pictures were");
}

}  // namespace
}  // namespace rovio_sfm
