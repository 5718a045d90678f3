#include "rovio_sfm/app/store_folder.h"

#include <gtest/gtest.h>

#include "mapping/mapped_drive.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

std::string RefusalOf(const std::filesystem::path& folder, ExistingStore existing) {
  try {
    StoreFolder again(folder, existing);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

void KeepOneFrame(MapStore* store) {
  store->Put(MakeSyntheticDrive({}).events.front());
  ASSERT_TRUE(store->Commit([] {}));
}

TEST(StoreFolder, AnExistingStoreIsRefusedResumedOrReplaced) {
  TemporaryFolder folder;
  const auto maps = folder.Path() / "new" / "maps";
  { KeepOneFrame(&StoreFolder(maps, ExistingStore::kRefuse).store()); }
  EXPECT_NE(RefusalOf(maps, ExistingStore::kRefuse).find("--resume"), std::string::npos);
  EXPECT_EQ(StoreFolder(maps, ExistingStore::kResume).store().frames().ReadDrives().size(), 1u);
  EXPECT_TRUE(StoreFolder(maps, ExistingStore::kReplace).store().frames().ReadDrives().empty());
}

size_t NumDrivesIn(const std::filesystem::path& file) {
  return MapStore(file, StoreAccess::kRead).frames().ReadDrives().size();
}

TEST(StoreFolder, WhatIsReplacedStaysUntilThereIsSomethingElse) {
  TemporaryFolder folder;
  const auto replaced = StoreFolder::ReplacedIn(folder.Path());
  { KeepOneFrame(&StoreFolder(folder.Path(), ExistingStore::kRefuse).store()); }
  { const StoreFolder ended_early(folder.Path(), ExistingStore::kReplace); }
  EXPECT_EQ(NumDrivesIn(replaced), 1u);
  { const StoreFolder ended_again(folder.Path(), ExistingStore::kReplace); }
  EXPECT_EQ(NumDrivesIn(replaced), 1u);
  StoreFolder(folder.Path(), ExistingStore::kReplace).DropReplaced();
  EXPECT_FALSE(std::filesystem::exists(replaced));
  EXPECT_EQ(NumDrivesIn(StoreFolder::FileIn(folder.Path())), 0u);
}

TEST(StoreFolder, AStoreIsBackWhereNoneTookItsPlace) {
  TemporaryFolder folder;
  { KeepOneFrame(&StoreFolder(folder.Path(), ExistingStore::kRefuse).store()); }
  std::filesystem::rename(StoreFolder::FileIn(folder.Path()),
                          StoreFolder::ReplacedIn(folder.Path()));
  EXPECT_NE(RefusalOf(folder.Path(), ExistingStore::kRefuse).find("--resume"), std::string::npos);
  EXPECT_EQ(StoreFolder(folder.Path(), ExistingStore::kResume).store().frames().ReadDrives().size(),
            1u);
}

TEST(StoreFolder, WhatIsNoStoreIsReplacedToo) {
  TemporaryFolder folder;
  folder.Write("map.db", "a letter to my aunt");
  const StoreFolder fresh(folder.Path(), ExistingStore::kReplace);
  EXPECT_TRUE(fresh.store().error().empty());
  EXPECT_EQ(std::filesystem::file_size(StoreFolder::ReplacedIn(folder.Path())), 19u);
}

TEST(StoreFolder, OneProcessAtATime) {
  TemporaryFolder folder;
  StoreFolder first(folder.Path(), ExistingStore::kRefuse);
  EXPECT_NE(RefusalOf(folder.Path(), ExistingStore::kResume).find("another process"),
            std::string::npos);
}

TEST(StoreFolder, AFileThatIsNoStoreStaysWhatItIs) {
  TemporaryFolder folder;
  const auto file = folder.Write("map.db", "a letter to my aunt");
  const std::string refusal = RefusalOf(folder.Path(), ExistingStore::kResume);
  EXPECT_NE(refusal.find(file.string()), std::string::npos) << refusal;
  EXPECT_EQ(std::filesystem::file_size(file), 19u);
}

TEST(StoreFolder, StartingAnewKeepsTheOldMaps) {
  TemporaryFolder folder;
  StoreFolder maps(folder.Path(), ExistingStore::kRefuse);
  KeepOneFrame(&maps.store());
  const auto aside = maps.StartAnew();
  EXPECT_TRUE(maps.store().frames().ReadDrives().empty());
  MapStore old(aside, StoreAccess::kRead);
  EXPECT_EQ(old.frames().ReadDrives().size(), 1u);
}

}  // namespace
}  // namespace rovio_sfm
