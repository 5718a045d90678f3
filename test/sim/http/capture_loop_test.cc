#include "rovio_sfm/sim/http/capture_loop.h"

#include <gtest/gtest.h>

#include <thread>

#include "sim/http/face_fixture.h"

namespace rovio_sfm::sim {
namespace {

std::string LatestText(FaceFixture& face) {
  const auto picture = face.context.frames.Latest();
  return picture ? std::string(picture->jpeg->begin(), picture->jpeg->end()) : "";
}

TEST(CaptureOnce, PublishesThePicture) {
  FaceFixture face;
  EXPECT_TRUE(CaptureOnce(face.context));
  EXPECT_EQ(LatestText(face), FakeRobot::PictureText(1));
}

TEST(CaptureOnce, PublishesNothingWhileStalled) {
  FaceFixture face;
  ASSERT_TRUE(face.SetQuirk("stall", 10));
  EXPECT_FALSE(CaptureOnce(face.context));
  face.now_ns += 10'000'000'000;
  EXPECT_TRUE(CaptureOnce(face.context));
}

TEST(CaptureOnce, QuirkCutsPictures) {
  FaceFixture face;
  ASSERT_TRUE(face.SetQuirk("truncate_jpeg", 2));
  CaptureOnce(face.context);
  EXPECT_EQ(LatestText(face), FakeRobot::PictureText(1));
  CaptureOnce(face.context);
  EXPECT_EQ(LatestText(face), FakeRobot::PictureText(2).substr(0, 7));
}

TEST(CaptureOnce, RobotWithoutPicturesPublishesNothing) {
  FaceFixture face;
  face.robot.has_pictures = false;
  EXPECT_FALSE(CaptureOnce(face.context));
  EXPECT_EQ(LatestText(face), "");
}

TEST(RunCaptureLoop, FeedsWaitingClientsUntilTheFeedCloses) {
  FaceFixture face;
  std::thread loop([&] { RunCaptureLoop(face.context); });
  const auto first = face.context.frames.WaitForNewer(0, std::chrono::hours(1));
  ASSERT_TRUE(first);
  EXPECT_TRUE(face.context.frames.WaitForNewer(first->number, std::chrono::hours(1)));
  face.context.stop.Request();
  face.context.frames.Close();
  loop.join();
}

}  // namespace
}  // namespace rovio_sfm::sim
