#include "rovio_sfm/rovio/robot_reporter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "rovio/fake_http_transport.h"

namespace rovio_sfm {
namespace {

constexpr char kMcuReport[] = "Cmd = nav\nresponses = 0E0102000A05000B00000003CB744B\n";
constexpr char kReport[] =
    "Cmd = nav\nresponses = 0|x=3718|y=3495|theta=0.863|room=0|ss=60\n"
    "|state=0|flags=0001|brightness=6|resolution=2|video_compression=2|frame_rate=15\n"
    "|user_check=1|wifi_ss=212|battery=123|charging=0|head_position=202\n";

class RobotReporterTest : public testing::Test {
 protected:
  RobotReporterTest() {
    options_.wanted_settings = CameraSettings{};
    MakeReporter();
  }

  void MakeReporter() {
    RobotReporter::Callbacks callbacks;
    callbacks.on_mcu = [this](const McuReport& mcu, const ReadingTime& time) {
      times_.push_back(time);
      readings_.push_back(mcu);
    };
    callbacks.on_lost_mcu = [this] { ++num_lost_; };
    callbacks.on_report = [this](const RobotReport&) { ++num_reports_; };
    callbacks.on_link = [this](bool is_up, const std::string& reason) {
      links_.push_back(is_up);
      reason_ = reason;
    };
    callbacks.on_settings = [this](bool has_obeyed, const SomeSettings&) {
      obeyed_.push_back(has_obeyed);
    };
    callbacks.now_ns = [this] { return now_ns_ + clock_offset_ns_; };
    callbacks.steady_ns = [this] { return now_ns_; };
    reporter_ = std::make_unique<RobotReporter>(options_, &robot_, callbacks);
  }

  void AskAfter(double seconds) {
    now_ns_ += static_cast<int64_t>(seconds * 1e9);
    reporter_->AskMcu();
  }

  FakeHttpTransport robot_;
  ReporterOptions options_;
  std::unique_ptr<RobotReporter> reporter_;
  int64_t now_ns_ = 0, clock_offset_ns_ = 1'000'000'000'000;
  std::vector<ReadingTime> times_;
  std::vector<McuReport> readings_;
  std::vector<bool> links_, obeyed_;
  std::string reason_;
  int num_lost_ = 0, num_reports_ = 0;
};

TEST_F(RobotReporterTest, HandsOnReadingsAndSaysOnceThatTheLinkIsUp) {
  robot_.Answer(McuReportTarget(), FakeHttpTransport::Ok(kMcuReport));
  for (int i = 0; i < 5; ++i) AskAfter(0.05);
  ASSERT_EQ(readings_.size(), 5u);
  EXPECT_EQ(readings_[0].wheels[0].ticks, 10);
  EXPECT_EQ(links_, (std::vector<bool>{true}));
}

TEST_F(RobotReporterTest, BacksOffWhileTheRobotIsAwayAndTellsOnce) {
  robot_.Answer(McuReportTarget(), FakeHttpTransport::Fault(HttpFault::kConnect));
  for (int i = 0; i < 200; ++i) AskAfter(0.05);  // ten seconds
  EXPECT_EQ(robot_.targets.size(), 6u);          // at 0, 0.25, 0.75, 1.75, 3.75, 7.75 s
  EXPECT_EQ(num_lost_, 6);
  EXPECT_EQ(links_, (std::vector<bool>{false}));
}

TEST_F(RobotReporterTest, GoesOnAskingWhenTheClockStepsBack) {
  robot_.Answer(McuReportTarget(), FakeHttpTransport::Ok(kMcuReport));
  AskAfter(0.05);
  clock_offset_ns_ -= 300'000'000'000;
  AskAfter(0.05);
  ASSERT_EQ(times_.size(), 2u);
  EXPECT_EQ(times_[1].steady_ns - times_[0].steady_ns, 50'000'000);
  EXPECT_EQ(times_[1].stamp_ns - times_[0].stamp_ns, 50'000'000 - 300'000'000'000);
}

TEST_F(RobotReporterTest, BackOffEndsThoughTheClockStepsBack) {
  robot_.Answer(McuReportTarget(), FakeHttpTransport::Fault(HttpFault::kTimeout));
  robot_.Answer(McuReportTarget(), FakeHttpTransport::Ok(kMcuReport));
  AskAfter(0.05);
  clock_offset_ns_ -= 300'000'000'000;
  AskAfter(0.3);
  EXPECT_EQ(times_.size(), 1u);
}

TEST_F(RobotReporterTest, TellsARobotThatIsSilentForTwoSecondsWhateverTheFailures) {
  options_.max_failures = 1000;
  MakeReporter();
  robot_.Answer(McuReportTarget(), FakeHttpTransport::Fault(HttpFault::kTimeout));
  for (int i = 0; i < 36; ++i) AskAfter(0.05);  // asked at 0.05, 0.3, 0.8 and 1.8 s
  EXPECT_TRUE(links_.empty());
  for (int i = 0; i < 45; ++i) AskAfter(0.05);  // and at 3.8 s
  EXPECT_EQ(links_, (std::vector<bool>{false}));
}

TEST_F(RobotReporterTest, AskedOnceInVainItStaysUp) {
  robot_.Answer(McuReportTarget(), FakeHttpTransport::Ok(kMcuReport));
  robot_.Answer(McuReportTarget(), FakeHttpTransport::Fault(HttpFault::kTimeout));
  robot_.Answer(McuReportTarget(), FakeHttpTransport::Ok(kMcuReport));
  for (int i = 0; i < 3; ++i) AskAfter(1.0);
  EXPECT_EQ(num_lost_, 1);
  EXPECT_EQ(links_, (std::vector<bool>{true}));
}

TEST_F(RobotReporterTest, SaysThatTheLoginWasRefused) {
  robot_.Answer(McuReportTarget(), FakeHttpTransport::Status(401));
  for (int i = 0; i < 3; ++i) AskAfter(10.0);
  EXPECT_EQ(links_, (std::vector<bool>{false}));
  EXPECT_EQ(reason_, "login refused (401)");
}

TEST_F(RobotReporterTest, AsksForTheSettingsOnceAndReadsThemBack) {
  robot_.Answer(ReportTarget(), FakeHttpTransport::Ok(kReport));
  robot_.Answer(ResolutionTarget(3), FakeHttpTransport::Ok(""));
  for (int i = 0; i < 10; ++i) {
    now_ns_ += 1000000000;
    reporter_->AskReport();
  }
  EXPECT_EQ(num_reports_, 10);
  EXPECT_EQ(std::count(robot_.targets.begin(), robot_.targets.end(), ResolutionTarget(3)), 1);
  EXPECT_EQ(obeyed_, (std::vector<bool>{false}));  // this robot answers 200 and does nothing
}

// A robot that starts anew has forgotten what it was asked for.
TEST_F(RobotReporterTest, AsksForTheSettingsAgainWhenTheRobotWasAway) {
  std::string obeyed = kReport;
  obeyed.replace(obeyed.find("resolution=2"), 12, "resolution=3");
  robot_.Answer(ResolutionTarget(3), FakeHttpTransport::Ok(""));
  for (const bool goes_away : {true, false}) {
    robot_.Answer(ReportTarget(), FakeHttpTransport::Ok(kReport));
    robot_.Answer(ReportTarget(), FakeHttpTransport::Ok(obeyed));
    for (int i = 0; goes_away && i < options_.max_failures; ++i) {
      robot_.Answer(ReportTarget(), FakeHttpTransport::Fault(HttpFault::kConnect));
    }
  }
  for (int i = 0; i < 8; ++i) {
    now_ns_ += 10'000'000'000;
    reporter_->AskReport();
  }
  EXPECT_EQ(std::count(robot_.targets.begin(), robot_.targets.end(), ResolutionTarget(3)), 2);
  EXPECT_EQ(obeyed_, (std::vector<bool>{true, true}));
  EXPECT_EQ(links_, (std::vector<bool>{true, false, true}));
}

}  // namespace
}  // namespace rovio_sfm
