#include "rovio_sfm/app/folder_lock.h"

#include <optional>

#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

TEST(FolderLock, HoldsAFolderOnce) {
  const TemporaryFolder folder;
  const auto lock = [&] { FolderLock(folder.Path()); };
  std::optional<FolderLock> held(folder.Path());
  EXPECT_EQ(MessageOf(lock), folder.Path().string() + ": another process maps into this folder");
  held.reset();
  EXPECT_NO_THROW(lock());
}

TEST(FolderLock, NamesAFolderThatIsNotThere) {
  EXPECT_EQ(MessageOf([] { FolderLock("/nowhere"); }),
            "/nowhere/map.db.lock: cannot be made or opened");
}

}  // namespace
}  // namespace rovio_sfm
