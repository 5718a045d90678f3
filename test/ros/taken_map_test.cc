#include "rovio_sfm/ros/taken_map.h"

#include <gtest/gtest.h>

#include "merging/two_drives.h"

namespace rovio_sfm {
namespace {

// Two robots that have not met: maps 1 and 2, the second smaller.
class TakeMapTest : public testing::Test {
 protected:
  TakeMapTest() {
    const TwoDrives two = MakeTwoDrives();
    for (size_t i = 0; i < 8; ++i) engine_.Add(two.a[i]);
    for (size_t i = 0; i < 6; ++i) engine_.Add(two.b[i]);
  }

  MappingEngine engine_{MapOptions()};
};

TEST_F(TakeMapTest, TakesTheMapOfASession) {
  const TakenMap taken = TakeMap(engine_, 2);
  ASSERT_EQ(taken.status.code, Status::OK) << taken.status.message;
  EXPECT_EQ(taken.gauge.map.value, 2u);
  EXPECT_EQ(taken.model.images.size(), 6u);
  EXPECT_TRUE(*GaugeOf(taken.picture, {2}) == taken.gauge);
}

TEST_F(TakeMapTest, TakesTheLargestWhereNoneIsNamed) {
  const TakenMap taken = TakeMap(engine_, 0);
  ASSERT_EQ(taken.status.code, Status::OK) << taken.status.message;
  EXPECT_EQ(taken.gauge.map.value, 1u);
  EXPECT_EQ(taken.model.images.size(), 8u);
}

TEST_F(TakeMapTest, SaysWhatIsNotThere) {
  const TakenMap unknown = TakeMap(engine_, 7);
  EXPECT_EQ(unknown.status.code, Status::NOT_FOUND);
  EXPECT_NE(unknown.status.message.find("session 7"), std::string::npos) << unknown.status.message;
  const TakenMap nothing = TakeMap(MappingEngine(MapOptions()), 0);
  EXPECT_EQ(nothing.status.code, Status::NOT_FOUND);
}

}  // namespace
}  // namespace rovio_sfm
