#include "rovio_sfm/places/word_bag.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(BagOfWords, KeepsEachWordOnceInOrder) {
  EXPECT_EQ(BagOfWords({7, 2, 7, 0, 2}), (WordBag{0, 2, 7}));
}

TEST(BagOfWords, IsEmptyWithoutWords) { EXPECT_TRUE(BagOfWords({}).empty()); }

}  // namespace
}  // namespace rovio_sfm
