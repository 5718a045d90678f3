#include "rovio_sfm/app/image_gate.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

constexpr int64_t kSecondNs = 1000000000;

// A robot whose odometry and whose head's pose reach up to a stamp each.
class FakeRobot : public RobotKnowledge {
 public:
  bool HasCamera() const override { return true; }
  bool HasOdometry() const override { return newest_ns_ > 0; }
  bool OdometryCovers(const RawImage& image) const override { return newest_ns_ >= image.stamp_ns; }
  bool HasHead(const RawImage&) const override { return newest_head_ns_ > 0; }
  bool KnowsHead(const RawImage& image) const override { return newest_head_ns_ >= image.stamp_ns; }
  ImageEvent MakeEvent(const RawImage& image) const override {
    ImageEvent event;
    event.name = image.name;
    if (OdometryCovers(image)) event.odometry = OdometrySample{};
    if (KnowsHead(image)) event.base_from_camera = Rigid3{};
    return event;
  }

  int64_t newest_ns_ = 0;
  int64_t newest_head_ns_ = 0;
};

class ImageGateTest : public testing::Test {
 protected:
  ImageGateTest() : gate_(GateOptions(), &robot_) {}

  static RawImage Image(int64_t second) {
    return {second * kSecondNs, "camera_optical", std::to_string(second), nullptr};
  }

  void AddOdometry(int64_t second) { robot_.newest_ns_ = second * kSecondNs; }
  void AddHead(int64_t second) { robot_.newest_head_ns_ = second * kSecondNs; }

  FakeRobot robot_;
  ImageGate gate_;
};

TEST_F(ImageGateTest, CompleteImageGoesAtOnce) {
  AddHead(100);
  AddOdometry(100);
  gate_.Add(Image(100), 0.0);
  const auto event = gate_.Take(0.0);
  ASSERT_TRUE(event);
  EXPECT_TRUE(event->odometry);
  EXPECT_FALSE(gate_.Take(0.0));
}

TEST_F(ImageGateTest, ImageWaitsForOdometryUpToItsStamp) {
  AddHead(101);
  AddOdometry(99);
  gate_.Add(Image(100), 0.0);
  EXPECT_FALSE(gate_.Take(0.1));
  AddOdometry(101);
  EXPECT_TRUE(gate_.Take(0.1));
}

TEST_F(ImageGateTest, ImageWaitsNotForEver) {
  AddHead(101);
  AddOdometry(99);
  gate_.Add(Image(100), 5.0);
  gate_.Add(Image(101), 7.0);
  EXPECT_TRUE(gate_.Take(7.0));
  EXPECT_FALSE(gate_.Take(7.2));
  EXPECT_TRUE(gate_.Take(7.31));
}

TEST_F(ImageGateTest, WithoutOdometryAndHeadOnlyTheStartWaits) {
  gate_.Add(Image(100), 0.0);
  EXPECT_FALSE(gate_.Take(0.9));
  EXPECT_TRUE(gate_.Take(1.0));
  gate_.Add(Image(101), 1.1);
  EXPECT_TRUE(gate_.Take(1.1));
}

// On a slow machine the first pose comes long after the first image, and each after its image.
TEST_F(ImageGateTest, ImageWaitsForAHeadThatFirstCameLate) {
  AddOdometry(200);
  gate_.Add(Image(100), 0.0);
  EXPECT_TRUE(gate_.Take(1.5));
  AddHead(100);
  gate_.Add(Image(101), 2.0);
  EXPECT_FALSE(gate_.Take(2.0));
  AddHead(101);
  const auto event = gate_.Take(2.1);
  ASSERT_TRUE(event);
  EXPECT_TRUE(event->base_from_camera);
}

TEST_F(ImageGateTest, OldestIsDroppedWhenFull) {
  for (int64_t i = 0; i <= static_cast<int64_t>(ImageGate::kCapacity); ++i) {
    gate_.Add(Image(100 + i), 0.0);
  }
  EXPECT_EQ(gate_.NumDropped(), 1u);
  const auto event = gate_.Take(10.0);
  ASSERT_TRUE(event);
  EXPECT_EQ(event->name, "101");
}

TEST_F(ImageGateTest, OldestIsDroppedWhenFullOfBytes) {
  for (int64_t i = 0; i < 3; ++i) {
    RawImage image = Image(100 + i);
    image.bytes = std::make_shared<const std::vector<uint8_t>>(ImageGate::kMaxBytes / 2 + 1);
    gate_.Add(std::move(image), 0.0);
  }
  EXPECT_EQ(gate_.NumDropped(), 1u);
  const auto event = gate_.Take(10.0);
  ASSERT_TRUE(event);
  EXPECT_EQ(event->name, "101");
}

}  // namespace
}  // namespace rovio_sfm
