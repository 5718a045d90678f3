#include "rovio_sfm/io/dataset_folder.h"

#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

// Three images 0.5 s apart, with odometry at 0 s and 1 s.
void WriteDataset(const TemporaryFolder& folder) {
  folder.Write("calibration.txt", "500 500 320 240 0 0 0 0 0 640 480\n");
  folder.Write("times.txt",
               "# timestamp filename\n10.0 images/a.jpg\n10.5 images/b.jpg\n11.0 images/c.jpg\n");
  for (const char* name : {"a", "b", "c"}) folder.Write(std::string("images/") + name + ".jpg", "");
  folder.Write("odometry.txt", "10 0 0 0 1 0 0 0 1 0 0 0 1\n11 2 0 0 1 0 0 0 1 0 0 0 1\n");
  folder.Write("extrinsics.txt", "10 0.1 0 0.2 0 0 0 1\n");
  folder.Write("overlaps.txt", "0 2 0.5 10\n");
}

TEST(ReadDatasetFolder, ReadsImagesWithOdometryAndExtrinsics) {
  const TemporaryFolder folder;
  WriteDataset(folder);
  const DatasetFolder dataset = ReadDatasetFolder(folder.Path());
  ASSERT_EQ(dataset.images.size(), 3u);
  EXPECT_EQ(dataset.images[1].stamp_ns, 10500000000);
  EXPECT_EQ(dataset.images[1].name, "images/b.jpg");
  ASSERT_TRUE(dataset.images[1].odometry.has_value());
  EXPECT_NEAR(dataset.images[1].odometry->x_m, 1.0, 1e-12);
  ASSERT_TRUE(dataset.images[2].base_from_camera.has_value());
  EXPECT_NEAR(dataset.images[2].base_from_camera->translation.z(), 0.2, 1e-12);
  ASSERT_EQ(dataset.overlaps.size(), 1u);
  EXPECT_EQ(dataset.overlaps[0].image_b, 2u);
  EXPECT_TRUE(dataset.ground_truth.empty());
}

TEST(ReadDatasetFolder, DoesWithoutOptionalFiles) {
  const TemporaryFolder folder;
  WriteDataset(folder);
  for (const char* name : {"odometry.txt", "extrinsics.txt", "overlaps.txt"}) {
    std::filesystem::remove(folder.Path() / name);
  }
  const DatasetFolder dataset = ReadDatasetFolder(folder.Path());
  EXPECT_FALSE(dataset.images[0].odometry.has_value());
  EXPECT_FALSE(dataset.images[0].base_from_camera.has_value());
}

TEST(ReadDatasetFolder, TakesWhatEditorsAndNumpyWrite) {
  const TemporaryFolder folder;
  WriteDataset(folder);
  std::filesystem::remove(folder.Path() / "overlaps.txt");
  folder.Write("images/with two blanks.jpg", "");
  folder.Write("times.txt",
               "\xEF\xBB\xBF# timestamp filename\r\n1.000000000000000000e+01 images/a.jpg\r\n"
               "+1.05e1 \t images/with two blanks.jpg \r\n");
  const DatasetFolder dataset = ReadDatasetFolder(folder.Path());
  ASSERT_EQ(dataset.images.size(), 2u);
  EXPECT_EQ(dataset.images[0].stamp_ns, 10000000000);
  EXPECT_EQ(dataset.images[1].stamp_ns, 10500000000);
  EXPECT_EQ(dataset.images[1].name, "images/with two blanks.jpg");
}

TEST(ReadDatasetFolder, LeavesOutALateImage) {
  const TemporaryFolder folder;
  WriteDataset(folder);
  std::filesystem::remove(folder.Path() / "overlaps.txt");
  folder.Write("times.txt",
               "10 images/a.jpg\n10 images/b.jpg\n9.5 images/b.jpg\n11 images/c.jpg\n");
  const DatasetFolder dataset = ReadDatasetFolder(folder.Path());
  ASSERT_EQ(dataset.images.size(), 2u);
  EXPECT_EQ(dataset.images[1].name, "images/c.jpg");
  folder.Write("times.txt", "10 images/a.jpg\n8.9 images/b.jpg\n");
  EXPECT_NE(MessageOf([&] { ReadDatasetFolder(folder.Path()); }).find("times.txt:2"),
            std::string::npos);
}

TEST(ReadDatasetFolder, NamesWhatIsWrong) {
  const std::pair<const char*, const char*> bad[] = {
      {"times.txt", "10 ../a.jpg\n"},
      {"times.txt", "10 images/missing.jpg\n"},
      {"times.txt", "10 images/a.jpg\n10 images/b.jpg\n"},
      {"times.txt", "10\n"},
      {"times.txt", "\n"},
      {"overlaps.txt", "0 3 0.5 10\n"},
      {"groundtruth.txt", "1 2 3\n"},
      {"extrinsics.txt", "1 2 3\n"}};
  for (const auto& [name, text] : bad) {
    const TemporaryFolder folder;
    WriteDataset(folder);
    folder.Write(name, text);
    const std::string message = MessageOf([&] { ReadDatasetFolder(folder.Path()); });
    EXPECT_NE(message.find(name), std::string::npos) << name << ": " << message;
  }
  EXPECT_NE(MessageOf([] { ReadDatasetFolder("no/such/folder"); }), "");
}

TEST(ReadDatasetFolder, NamesTheLineOfALinkThatLeadsRoundInACircle) {
  const TemporaryFolder folder;
  WriteDataset(folder);
  const std::filesystem::path image = folder.Path() / "images/b.jpg";
  std::filesystem::remove(image);
  std::filesystem::create_symlink("b.jpg", image);
  EXPECT_EQ(MessageOf([&] { ReadDatasetFolder(folder.Path()); }),
            (folder.Path() / "times.txt").string() +
                ":3: field filename: Too many levels of symbolic links: " + image.string());
}

TEST(EveryNth, ThinsImagesAndOverlaps) {
  const TemporaryFolder folder;
  WriteDataset(folder);
  const DatasetFolder thinned = EveryNth(ReadDatasetFolder(folder.Path()), 2);
  ASSERT_EQ(thinned.images.size(), 2u);
  EXPECT_EQ(thinned.images[1].name, "images/c.jpg");
  ASSERT_EQ(thinned.overlaps.size(), 1u);
  EXPECT_EQ(thinned.overlaps[0].image_b, 1u);
}

}  // namespace
}  // namespace rovio_sfm
