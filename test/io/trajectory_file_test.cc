#include "rovio_sfm/io/trajectory_file.h"

#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kSecond = 1'000'000'000;

StampedPose PoseAt(int64_t stamp_ns, double x, double yaw_rad) {
  return {
      stamp_ns,
      {Eigen::Quaterniond(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ())), {x, 2.0, 3.0}}};
}

TEST(Trajectory, RoundTrips) {
  const TemporaryFolder folder;
  const std::vector<StampedPose> written = {PoseAt(1305031102175304000, 0.5, 0.1),
                                            PoseAt(1305031102211214000, 0.6, 0.2)};
  const auto read = ReadTrajectory(folder.Write("t.txt", TrajectoryText(written)));
  ASSERT_EQ(read.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read[i].stamp_ns, written[i].stamp_ns);
    const Rigid3 &a = read[i].reference_from_body, &b = written[i].reference_from_body;
    EXPECT_LT((a.translation - b.translation).norm(), 1e-8);
    EXPECT_LT(a.rotation.angularDistance(b.rotation), 1e-7);
  }
}

TEST(ReadTrajectory, NamesTheLineThatIsWrong) {
  const TemporaryFolder folder;
  const char* bad[] = {"1 0 0 0 0 0 0\n", "1 0 0 0 0 0 0 2\n", "1 0 0 0 0 0 0 x\n",
                       "1 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n", "1 0 0 0 0 0 0 0\n"};
  for (const char* text : bad) {
    const auto path = folder.Write("t.txt", text);
    EXPECT_NE(MessageOf([&] { ReadTrajectory(path); }).find("t.txt:"), std::string::npos) << text;
  }
}

TEST(InterpolatePose, IsHalfWayInTheMiddle) {
  const std::vector<StampedPose> two = {PoseAt(0, 0.0, 0.0), PoseAt(kSecond, 1.0, 0.4)};
  const auto middle = InterpolatePose(two, kSecond / 2, kSecond);
  ASSERT_TRUE(middle.has_value());
  EXPECT_NEAR(middle->translation.x(), 0.5, 1e-12);
  EXPECT_NEAR(RotationAngle(middle->rotation), 0.2, 1e-12);
}

TEST(InterpolatePose, RefusesGapsButTakesExactStamps) {
  const std::vector<StampedPose> two = {PoseAt(0, 0.0, 0.0), PoseAt(kSecond, 1.0, 0.0)};
  EXPECT_FALSE(InterpolatePose(two, kSecond / 2, kSecond - 1).has_value());
  EXPECT_FALSE(InterpolatePose(two, -1, kSecond).has_value());
  EXPECT_FALSE(InterpolatePose(two, kSecond + 1, kSecond).has_value());
  EXPECT_TRUE(InterpolatePose(two, 0, 1).has_value());
  EXPECT_TRUE(InterpolatePose(two, kSecond, 1).has_value());
  EXPECT_FALSE(InterpolatePose({}, 0, 1).has_value());
}

}  // namespace
}  // namespace rovio_sfm
