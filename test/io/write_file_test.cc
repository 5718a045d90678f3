#include "rovio_sfm/io/write_file.h"

#include "rovio_sfm/io/text_file.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

std::string Content(const std::filesystem::path& path) {
  const auto bytes = ReadBytes(path, 1000);
  return {bytes.begin(), bytes.end()};
}

size_t NumFiles(const std::filesystem::path& folder) {
  const std::filesystem::directory_iterator files(folder);
  return static_cast<size_t>(std::distance(begin(files), end(files)));
}

TEST(WriteFile, RefusesToReplaceUnlessAllowed) {
  const TemporaryFolder folder;
  const auto path = folder.Path() / "a.txt";
  WriteFile(path, "one", Overwrite::kRefuse);
  EXPECT_NE(MessageOf([&] { WriteFile(path, "two", Overwrite::kRefuse); }).find("a.txt"),
            std::string::npos);
  EXPECT_EQ(Content(path), "one");
  WriteFile(path, "three", Overwrite::kAllow);
  EXPECT_EQ(Content(path), "three");
  EXPECT_EQ(NumFiles(folder.Path()), 1u);
}

TEST(WriteFile, LeavesNothingBehindWhereItFails) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.Path() / "is_a_folder");
  folder.Write("is_a_folder/x", "");
  EXPECT_NE(MessageOf([&] { WriteFile(folder.Path() / "is_a_folder", "x", Overwrite::kAllow); }),
            "");
  EXPECT_EQ(NumFiles(folder.Path()), 1u);
  EXPECT_NE(MessageOf([&] { WriteFile(folder.Path() / "no/such", "x", Overwrite::kAllow); }), "");
}

}  // namespace
}  // namespace rovio_sfm
