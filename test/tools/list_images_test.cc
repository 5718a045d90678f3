#include "rovio_sfm/tools/list_images.h"

#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

TEST(ListImages, ReplacesFoldersByTheirImagesInOrder) {
  const TemporaryFolder folder;
  for (const char* name : {"a/2.png", "a/1.jpg", "a/notes.txt", "z.jpeg", "a/3.JPG", "a/4.Png"})
    folder.Write(name, "");
  const auto images = ListImages({folder.Path() / "z.jpeg", folder.Path() / "a"});
  ASSERT_EQ(images.size(), 5u);
  EXPECT_EQ(images[0].filename(), "z.jpeg");
  EXPECT_EQ(images[1].filename(), "1.jpg");
  EXPECT_EQ(images[2].filename(), "2.png");
  EXPECT_EQ(images[3].filename(), "3.JPG");
  EXPECT_EQ(images[4].filename(), "4.Png");
}

TEST(ListImages, RefusesWhatHoldsNone) {
  const TemporaryFolder folder;
  EXPECT_THROW(ListImages({folder.Path()}), std::runtime_error);
  EXPECT_THROW(ListImages({folder.Path() / "absent.jpg"}), std::runtime_error);
  EXPECT_THROW(ListImages({}), std::runtime_error);
}

}  // namespace
}  // namespace rovio_sfm
