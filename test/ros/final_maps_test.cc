#include "rovio_sfm/ros/final_maps.h"

#include <gtest/gtest.h>

#include "report/small_map.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

TEST(FinalMaps, AreReplacedByThoseThatCameLater) {
  const TemporaryFolder folder;
  FinalMaps maps(folder.Path(), false);
  maps.Write(*SmallMaps(2));
  EXPECT_EQ(FindMapFiles(folder.Path()).size(), 4u);
  maps.Write(*SmallMaps(1));
  EXPECT_TRUE(maps.IsWritten());
  EXPECT_EQ(FindMapFiles(folder.Path()).size(), 2u);
}

TEST(FinalMaps, StandBesideThoseOfAnOlderRun) {
  const TemporaryFolder folder;
  for (int i = 0; i < 3; ++i) FinalMaps(folder.Path(), false).Write(*SmallMaps(1));
  EXPECT_EQ(FindMapFiles(folder.Path()).size(), 2u);
  EXPECT_EQ(FindMapFiles(folder.Path() / "run_2").size(), 2u);
  EXPECT_EQ(FindMapFiles(folder.Path() / "run_3").size(), 2u);
}

TEST(FinalMaps, ReplaceOlderOnesWhereTheyMayAndThereIsAny) {
  const TemporaryFolder folder;
  FinalMaps(folder.Path(), false).Write(*SmallMaps(2));
  FinalMaps next(folder.Path(), true);
  next.Write(MapSnapshot());
  EXPECT_EQ(FindMapFiles(folder.Path()).size(), 4u);
  next.Write(*SmallMaps(1));
  EXPECT_EQ(FindMapFiles(folder.Path()).size(), 2u);
}

TEST(FinalMaps, SayWhereTheyCouldNotBeWritten) {
  FinalMaps maps("/proc/nowhere", false);
  maps.Write(*SmallMaps(1));
  EXPECT_FALSE(maps.IsWritten());
}

}  // namespace
}  // namespace rovio_sfm
