#include "rovio_sfm/rovio/image_reader.h"

#include <gtest/gtest.h>

#include <thread>

#include "rovio/fake_http_transport.h"
#include "util/jpeg_sample.h"

namespace rovio_sfm {
namespace {

constexpr int64_t kEpochNs = 1'600'000'000'000'000'000;
constexpr char kPartHeader[] = "--WINBONDBOUDARY\r\nContent-Type: image/jpeg\r\n\r\n";

// Runs a reader on a fake robot until it has waited so many times; nothing sleeps.
class ReaderRun {
 public:
  explicit ReaderRun(const ImageReaderOptions& options)
      : gate_(true), reader_(options, &robot, &gate_, MakeCallbacks()) {}

  void Run(int max_waits) {
    max_waits_ = max_waits;
    reader_.Run();
  }

  const ImageCounters& Counters() const { return reader_.Counters(); }

  FakeHttpTransport robot;
  std::vector<CameraImage> images;
  std::vector<ImageLink> links;
  std::vector<std::string> reasons;
  std::vector<double> waits_s;
  int64_t clock_offset_ns = 0;  // of the clock that stamps bear
  int64_t clock_jump_ns = 0;    // at each image
  size_t max_images = 1000;

 private:
  ImageReader::Callbacks MakeCallbacks() {
    ImageReader::Callbacks callbacks;
    callbacks.on_image = [this](CameraImage image) {
      images.push_back(std::move(image));
      clock_offset_ns += clock_jump_ns;
      if (images.size() >= max_images) gate_.Stop();
    };
    callbacks.on_link = [this](ImageLink link, const std::string& reason) {
      links.push_back(link);
      reasons.push_back(reason);
    };
    callbacks.now_ns = [this] { return kEpochNs + now_ns_ + clock_offset_ns; };
    callbacks.steady_ns = [this] { return now_ns_ += 1000000; };
    callbacks.wait = [this](double seconds) {
      waits_s.push_back(seconds);
      now_ns_ += static_cast<int64_t>(seconds * 1e9);
      return static_cast<int>(waits_s.size()) < max_waits_;
    };
    return callbacks;
  }

  ReaderGate gate_;
  int max_waits_ = 1;
  int64_t now_ns_ = 0;
  ImageReader reader_;
};

FakeHttpTransport::StreamScript StreamOf(std::vector<std::string> images) {
  FakeHttpTransport::StreamScript script;
  for (const std::string& image : images) script.chunks.push_back(kPartHeader + image);
  return script;
}

TEST(ImageReader, HandsOnTheImagesOfTheStreamWithRisingStamps) {
  ReaderRun run({});
  run.robot.AnswerStream(StreamOf({JpegSample(640, 480, 'a'), JpegSample(640, 480, 'b')}));
  run.Run(1);
  ASSERT_EQ(run.images.size(), 2u);
  EXPECT_EQ(run.images[0].jpeg, JpegSample(640, 480, 'a'));
  EXPECT_EQ(run.images[1].width_px, 640);
  EXPECT_GT(run.images[1].stamp_ns, run.images[0].stamp_ns);
  EXPECT_GE(run.images[1].complete_ns, run.images[1].first_byte_ns);
  EXPECT_EQ(run.links, (std::vector<ImageLink>{ImageLink::kStream, ImageLink::kDown}));
}

TEST(ImageReader, StampsFollowAClockThatStepsBack) {
  ReaderRun run({});
  run.clock_jump_ns = -300'000'000'000;
  run.robot.AnswerStream(StreamOf({JpegSample(640, 480, 'a'), JpegSample(640, 480, 'b')}));
  run.Run(1);
  ASSERT_EQ(run.images.size(), 2u);
  const int64_t apart_ns = run.images[1].first_byte_ns - run.images[0].first_byte_ns;
  EXPECT_GT(apart_ns, 0);
  EXPECT_EQ(run.images[1].stamp_ns - run.images[0].stamp_ns, apart_ns - 300'000'000'000);
}

TEST(ImageReader, StampsRiseThoughTheClockFallsALittle) {
  ReaderRun run({});
  run.clock_jump_ns = -100000000;
  run.robot.AnswerStream(
      StreamOf({JpegSample(640, 480, 'a'), JpegSample(640, 480, 'b'), JpegSample(640, 480, 'c')}));
  run.Run(1);
  ASSERT_EQ(run.images.size(), 3u);
  EXPECT_EQ(run.images[1].stamp_ns, run.images[0].stamp_ns + 1);
  EXPECT_EQ(run.images[2].stamp_ns, run.images[0].stamp_ns + 2);
}

TEST(ImageReader, DropsAndCountsDamagedImages) {
  ReaderRun run({});
  const std::string whole = JpegSample(640, 480);
  run.robot.AnswerStream(StreamOf({whole, whole.substr(0, whole.size() - 20),
                                   WithJpegSize(whole, 2000, 2000), std::string(300, 'x'), whole}));
  run.Run(1);
  EXPECT_EQ(run.images.size(), 2u);
  EXPECT_EQ(run.Counters().num_truncated, 1u);
  EXPECT_EQ(run.Counters().num_too_large, 1u);
  EXPECT_EQ(run.Counters().num_corrupt, 1u);
}

TEST(ImageReader, WaitsLongerFromFailureToFailureAndTellsOnce) {
  ReaderRun run({});
  run.Run(5);
  EXPECT_EQ(run.waits_s, (std::vector<double>{0.25, 0.5, 1.0, 2.0, 4.0}));
  EXPECT_EQ(run.links, (std::vector<ImageLink>{ImageLink::kDown}));
  EXPECT_EQ(run.Counters().num_failures, 5u);
}

TEST(ImageReader, FallsBackToStillsAndReturnsToTheStream) {
  ImageReaderOptions options;
  options.stream_retry_period_s = 1.0;
  ReaderRun run(options);
  FakeHttpTransport::StreamScript refused;
  refused.status = 404;
  refused.content_type = "text/html";
  run.robot.AnswerStream(refused);
  run.robot.AnswerStream(refused);
  run.robot.AnswerStream(StreamOf({JpegSample(640, 480, 's')}));
  run.robot.AnswerStill(FakeHttpTransport::Ok(JpegSample(640, 480)));
  run.Run(3);
  EXPECT_EQ(run.links, (std::vector<ImageLink>{ImageLink::kDown, ImageLink::kStills,
                                               ImageLink::kStream, ImageLink::kDown}));
  EXPECT_EQ(run.images.back().jpeg, JpegSample(640, 480, 's'));
  EXPECT_GT(run.images.size(), 10u);
  EXPECT_EQ(run.Counters().num_reconnects, 1u);
}

TEST(ImageReader, ResumesAfterTheLinkWasLost) {
  ReaderRun run({});
  FakeHttpTransport::StreamScript away;
  away.status = 0;
  away.fault = HttpFault::kConnect;
  run.robot.AnswerStream(StreamOf({JpegSample(640, 480)}));
  run.robot.AnswerStream(away);
  run.robot.AnswerStream(StreamOf({JpegSample(640, 480)}));
  run.Run(3);
  EXPECT_EQ(run.images.size(), 2u);
  EXPECT_EQ(run.Counters().num_reconnects, 1u);
  EXPECT_EQ(run.links, (std::vector<ImageLink>{ImageLink::kStream, ImageLink::kDown,
                                               ImageLink::kStream, ImageLink::kDown}));
}

TEST(ImageReader, SaysThatTheLoginWasRefused) {
  ReaderRun run({});
  FakeHttpTransport::StreamScript refused;
  refused.status = 401;
  run.robot.AnswerStream(refused);
  run.Run(1);
  EXPECT_EQ(run.reasons, (std::vector<std::string>{"stream: login refused (401)"}));
}

TEST(ImageReader, ARefusedLoginIsNoReasonToAskForStills) {
  ReaderRun run({});
  FakeHttpTransport::StreamScript refused;
  refused.status = 401;
  run.robot.AnswerStream(refused);
  run.robot.AnswerStill(FakeHttpTransport::Ok(JpegSample(640, 480)));
  run.max_images = 1;
  run.Run(6);
  EXPECT_TRUE(run.images.empty());
  EXPECT_EQ(run.robot.targets.size(), 6u);
  for (const std::string& target : run.robot.targets) EXPECT_EQ(target, run.robot.targets[0]);
}

TEST(ImageReader, ASourceOfStillsNeverOpensTheStream) {
  ImageReaderOptions options;
  options.source = ImageSource::kStills;
  ReaderRun run(options);
  run.max_images = 3;
  run.robot.AnswerStill(FakeHttpTransport::Ok(JpegSample(640, 480)));
  run.Run(1);
  EXPECT_EQ(run.robot.targets, (std::vector<std::string>{"/Jpeg/CamImg0.jpg", "/Jpeg/CamImg1.jpg",
                                                         "/Jpeg/CamImg2.jpg"}));
}

TEST(ImageReader, AStreamOfDamagedImagesOnlyIsAFailure) {
  ReaderRun run({});
  run.robot.AnswerStream(StreamOf({std::string(300, 'x')}));
  run.Run(2);
  EXPECT_TRUE(run.images.empty());
  EXPECT_EQ(run.links, (std::vector<ImageLink>{ImageLink::kDown}));
}

TEST(ImageReader, LeavesAStreamThatIdlesWithoutImages) {
  ReaderRun run({});
  FakeHttpTransport::StreamScript idle = StreamOf({JpegSample(640, 480)});
  idle.chunks.insert(idle.chunks.end(), 5000, "\r\n");  // the test's clock: some ms a chunk
  run.robot.AnswerStream(idle);
  run.Run(1);
  EXPECT_EQ(run.images.size(), 1u);
  EXPECT_EQ(run.reasons.back(), "stream: bytes, but no image");
}

TEST(ReaderGate, AClosedGateHoldsUntilItIsOpenedOrStopped) {
  ReaderGate gate(false);
  std::thread opener([&gate] { gate.SetOpen(true); });
  EXPECT_TRUE(gate.WaitUntilOpen());
  opener.join();
  gate.SetOpen(false);
  std::thread stopper([&gate] { gate.Stop(); });
  EXPECT_FALSE(gate.WaitUntilOpen());
  EXPECT_FALSE(gate.WaitFor(3600.0));
  stopper.join();
}

}  // namespace
}  // namespace rovio_sfm
