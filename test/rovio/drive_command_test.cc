#include "rovio_sfm/rovio/drive_command.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kMillisecond = 1000000;

TEST(ChooseDrive, KnowsTheEightDirections) {
  const DriveOptions options;
  const std::array<DriveCode, 8> expected = {
      DriveCode::kForward,  DriveCode::kForwardLeft,   DriveCode::kLeft,  DriveCode::kBackwardLeft,
      DriveCode::kBackward, DriveCode::kBackwardRight, DriveCode::kRight, DriveCode::kForwardRight};
  for (size_t i = 0; i < expected.size(); ++i) {
    for (const double off_rad : {-0.35, 0.0, 0.35}) {
      const double angle_rad = static_cast<double>(i) * M_PI / 4.0 + off_rad;
      EXPECT_EQ(
          ChooseDrive({0.2 * std::cos(angle_rad), 0.2 * std::sin(angle_rad), 0}, options).code,
          expected[i])
          << angle_rad;
    }
  }
}

TEST(ChooseDrive, TurnsWhenTheTurnIsTheGreaterMotionOfTheWheels) {
  const DriveOptions options;
  EXPECT_EQ(ChooseDrive({0, 0, 1.0}, options).code, DriveCode::kRotateLeft);
  EXPECT_EQ(ChooseDrive({0, 0, -1.0}, options).code, DriveCode::kRotateRight);
  EXPECT_EQ(ChooseDrive({0.1, 0, 1.0}, options).code, DriveCode::kRotateLeft);
  EXPECT_EQ(ChooseDrive({0.2, 0, 1.0}, options).code, DriveCode::kForward);
}

TEST(ChooseDrive, TakesTheNearestSpeedNumberAndClamps) {
  const DriveOptions options;
  EXPECT_EQ(ChooseDrive({9.0, 0, 0}, options).speed, 1);
  EXPECT_EQ(ChooseDrive({0.011, 0, 0}, options).speed, 10);
  EXPECT_EQ(ChooseDrive({0.19, 0, 0}, options).speed, 5);
}

TEST(ChooseDrive, StopsForNothingAndForNoNumber) {
  const DriveOptions options;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(ChooseDrive({0, 0, 0}, options).code, DriveCode::kStop);
  EXPECT_EQ(ChooseDrive({0.001, 0, 0.01}, options).code, DriveCode::kStop);
  EXPECT_EQ(ChooseDrive({nan, 0, 1}, options).code, DriveCode::kStop);
  EXPECT_EQ(ChooseDrive({0.1, 0, HUGE_VAL}, options).code, DriveCode::kStop);
}

// Runs the scheduler every 10 ms; the times at which it sends a motion and a stop.
struct Sent {
  std::vector<int64_t> moves_ms, stops_ms;
};
Sent RunFor(DriveScheduler* scheduler, int64_t from_ms, int64_t to_ms, bool link = true) {
  Sent sent;
  for (int64_t ms = from_ms; ms < to_ms; ms += 10) {
    const std::optional<DriveCommand> command = scheduler->Next(ms * kMillisecond);
    if (!command) continue;
    (command->code == DriveCode::kStop ? sent.stops_ms : sent.moves_ms).push_back(ms);
    scheduler->MarkSent(*command, link);
  }
  return sent;
}

TEST(DriveScheduler, RepeatsWhileTheWishIsYoungThenStopsOnce) {
  DriveScheduler scheduler({});
  scheduler.SetWish({0.2, 0, 0}, 0);
  const Sent sent = RunFor(&scheduler, 0, 2000);
  EXPECT_EQ(sent.moves_ms, (std::vector<int64_t>{0, 100, 200, 300, 400, 500}));
  EXPECT_EQ(sent.stops_ms, (std::vector<int64_t>{510}));
  EXPECT_FALSE(scheduler.IsMoving());
}

TEST(DriveScheduler, StopsAtOnceForAZeroWish) {
  DriveScheduler scheduler({});
  scheduler.SetWish({0.2, 0, 0}, 0);
  RunFor(&scheduler, 0, 50);
  scheduler.SetWish({}, 50 * kMillisecond);
  EXPECT_EQ(RunFor(&scheduler, 50, 1000).stops_ms, (std::vector<int64_t>{50}));
}

TEST(DriveScheduler, SendsNothingBeforeTheFirstWish) {
  DriveScheduler scheduler({});
  const Sent sent = RunFor(&scheduler, 0, 1000);
  EXPECT_TRUE(sent.moves_ms.empty() && sent.stops_ms.empty());
}

TEST(DriveScheduler, FloodedWithWishesKeepsItsPeriod) {
  DriveScheduler scheduler({});
  int num_sent = 0;
  for (int64_t ms = 0; ms < 1000; ++ms) {
    scheduler.SetWish({ms % 2 == 0 ? 0.2 : -0.2, 0, 0}, ms * kMillisecond);
    num_sent += scheduler.Next(ms * kMillisecond) ? 1 : 0;
  }
  EXPECT_EQ(num_sent, 10);
}

TEST(DriveScheduler, AfterALostLinkOnlyStopsUntilANewWish) {
  DriveScheduler scheduler({});
  scheduler.SetWish({0.2, 0, 0}, 0);
  const Sent lost = RunFor(&scheduler, 0, 400, false);
  EXPECT_EQ(lost.moves_ms, (std::vector<int64_t>{0}));
  EXPECT_EQ(lost.stops_ms, (std::vector<int64_t>{10, 110, 210, 310}));
  const Sent back = RunFor(&scheduler, 400, 1000);
  EXPECT_EQ(back.stops_ms, (std::vector<int64_t>{410}));
  EXPECT_TRUE(back.moves_ms.empty());
  scheduler.SetWish({0.2, 0, 0}, 1000 * kMillisecond);
  EXPECT_FALSE(RunFor(&scheduler, 1000, 1100).moves_ms.empty());
}

TEST(DriveScheduler, GivesUpToStopARobotThatIsGone) {
  DriveScheduler scheduler({});
  scheduler.SetWish({0.2, 0, 0}, 0);
  EXPECT_EQ(RunFor(&scheduler, 0, 60000, false).stops_ms.size(), 10u);
  EXPECT_FALSE(scheduler.IsMoving());
}

TEST(DriveOptions, RefusesTablesThatDoNotFallAndOddTimes) {
  std::string error;
  DriveOptions options;
  EXPECT_TRUE(IsValid(options, &error)) << error;
  options.speed_m_per_s[3] = 1.0;
  EXPECT_FALSE(IsValid(options, &error));
  options = {};
  options.repeat_period_ns = 1000000000;
  EXPECT_FALSE(IsValid(options, &error));
}

TEST(DriveScheduler, DoesNotTakeAMotionThatWaitedWhileTheProcessSlept) {
  DriveScheduler scheduler({});
  constexpr int64_t kSecond = 1'000'000'000;
  scheduler.NoteAwake(0);
  scheduler.NoteAwake(100 * kSecond);
  scheduler.SetWish({0.2, 0, 0}, 100 * kSecond);
  EXPECT_FALSE(scheduler.Next(100 * kSecond));
  scheduler.NoteAwake(100 * kSecond + kSecond / 4);
  scheduler.SetWish({0.2, 0, 0}, 100 * kSecond + kSecond / 4);
  EXPECT_TRUE(scheduler.Next(100 * kSecond + kSecond / 4));
}

}  // namespace
}  // namespace rovio_sfm
