#include "rovio_sfm/tools/read_picture.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kManyPixels = 1000;

TEST(ReadPicture, DecodesAFile) {
  const TemporaryFolder folder;
  const auto path = folder.Path() / "a.png";
  cv::imwrite(path.string(), cv::Mat(3, 4, CV_8UC3, cv::Scalar(1, 2, 3)));
  EXPECT_EQ(ReadPicture(path, kManyPixels).bgr.size(), cv::Size(4, 3));
}

TEST(ReadPicture, NamesTheFileThatCannotBeReadOrDecoded) {
  const TemporaryFolder folder;
  for (const auto& path : {folder.Path() / "absent.jpg", folder.Write("broken.jpg", "no image")}) {
    const DecodeResult result = ReadPicture(path, kManyPixels);
    EXPECT_TRUE(result.bgr.empty());
    EXPECT_EQ(result.reason.find(path.string() + ": "), 0u) << result.reason;
  }
}

}  // namespace
}  // namespace rovio_sfm
