#include "rovio_sfm/scene/ids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace rovio_sfm {
namespace {

TEST(DriveId, IsOrderedByStartThenRobotThenNonce) {
  const std::vector<DriveId> sorted = {
      {"zoe", 1, 9}, {"adam", 2, 5}, {"eve", 2, 0}, {"eve", 2, 1}, {"adam", 3, 0}};
  EXPECT_TRUE(std::is_sorted(sorted.begin(), sorted.end()));
  for (size_t i = 0; i + 1 < sorted.size(); ++i) {
    EXPECT_TRUE(sorted[i] < sorted[i + 1]);
    EXPECT_FALSE(sorted[i + 1] < sorted[i]);
    EXPECT_TRUE(sorted[i] != sorted[i + 1]);
  }
  EXPECT_TRUE(sorted[2] == (DriveId{"eve", 2, 0}));
}

TEST(FrameId, IsOrderedByDriveThenIndex) {
  const DriveId first{"adam", 1, 0}, second{"adam", 2, 0};
  EXPECT_TRUE((FrameId{first, 9}) < (FrameId{second, 0}));
  EXPECT_TRUE((FrameId{first, 1}) < (FrameId{first, 2}));
  EXPECT_TRUE((FrameId{first, 1}) == (FrameId{first, 1}));
  EXPECT_TRUE((FrameId{first, 1}) != (FrameId{second, 1}));
}

TEST(Ids, HaveReadableNames) {
  const FrameId id{{"rovio_1", 1500, 7}, 42};
  EXPECT_EQ(id.drive.ToString(), "rovio_1-1500-7");
  EXPECT_EQ(id.ToString(), "rovio_1-1500-7/42");
}

TEST(Ids, SessionsAndMapsCompareByValue) {
  EXPECT_TRUE(SessionId{1} == SessionId{1});
  EXPECT_TRUE(SessionId{1} != SessionId{2});
  EXPECT_TRUE(SessionId{1} < SessionId{2});
  EXPECT_TRUE(MapId{3} == MapId{3});
  EXPECT_TRUE(MapId{1} < MapId{2});
}

TEST(IsValidRobotName, AcceptsLowerCaseNames) {
  std::string error;
  for (const char* name : {"a", "rovio", "rovio_2", "r2d2"}) {
    EXPECT_TRUE(IsValidRobotName(name, &error)) << name;
  }
  EXPECT_TRUE(IsValidRobotName(std::string(32, 'a'), &error));
}

TEST(IsValidRobotName, RefusesOthersAndNamesThem) {
  std::string error;
  for (const char* name : {"", "Rovio", "2rovio", "_a", "a/b", "a-b", "a b", "rövio"}) {
    EXPECT_FALSE(IsValidRobotName(name, &error)) << name;
    EXPECT_NE(error.find(name), std::string::npos);
  }
  EXPECT_FALSE(IsValidRobotName(std::string(33, 'a'), &error));
}

}  // namespace
}  // namespace rovio_sfm
