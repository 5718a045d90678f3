#include "rovio_sfm/frontend/frontend.h"

#include <gtest/gtest.h>

#include <set>

#include "frontend/moving_images.h"

namespace rovio_sfm {
namespace {

FrontendOptions SmallOptions(KeyframeMode mode) {
  FrontendOptions options;
  options.choose.mode = mode;
  options.extract.max_features = 300;
  return options;
}

std::vector<FrameEvent> EventsOf(const FrontendOptions& options, double step_px, int count) {
  const MovingImages images;
  Frontend frontend(options, "rovio", 1, 5);
  std::vector<FrameEvent> events;
  for (int i = 0; i < count; ++i) {
    auto event = frontend.Add(MovingImages::Event(images.At(i * step_px), i));
    if (event) events.push_back(*event);
  }
  return events;
}

TEST(Frontend, EveryImageIsAKeyframeMatchedWithItsPredecessors) {
  const auto events = EventsOf(SmallOptions(KeyframeMode::kEvery), 8.0, 3);
  ASSERT_EQ(events.size(), 3u);
  EXPECT_TRUE(events[0].pairs.empty());
  ASSERT_EQ(events[2].pairs.size(), 2u);
  EXPECT_EQ(events[2].pairs[0].other_index, 1u);
  EXPECT_EQ(events[2].pairs[1].other_index, 0u);
  const PairMatches& pair = events[2].pairs[0];
  EXPECT_NE(pair.verdict, PairVerdict::kFailed);
  EXPECT_GT(pair.inliers.size(), 80u);
  EXPECT_GE(pair.counts.ratio, pair.counts.percentile);
  EXPECT_GE(pair.counts.percentile, pair.counts.one_to_one);
  EXPECT_GE(pair.counts.one_to_one, pair.counts.ransac);
  EXPECT_EQ(pair.counts.guided, pair.inliers.size());
}

TEST(Frontend, TellsByTracksWhatASearchWouldFind) {
  FrontendOptions options = SmallOptions(KeyframeMode::kEvery);
  const auto told = EventsOf(options, 8.0, 3);
  options.recursion.min_expected = 1'000'000;
  const auto searched = EventsOf(options, 8.0, 3);
  EXPECT_EQ(told[2].pairs[0].counts.ratio, searched[2].pairs[0].counts.ratio);
  EXPECT_NE(told[2].pairs[1].counts.ratio, searched[2].pairs[1].counts.ratio);
}

TEST(Frontend, MatchedFeaturesShareATrackUsedOnceAFrame) {
  const auto events = EventsOf(SmallOptions(KeyframeMode::kEvery), 8.0, 2);
  ASSERT_EQ(events.size(), 2u);
  size_t num_shared = 0;
  for (const FeatureMatch& match : events[1].pairs.at(0).inliers) {
    num_shared += events[0].tracks[match.a] == events[1].tracks[match.b];
  }
  EXPECT_GT(num_shared, events[1].pairs[0].inliers.size() * 9 / 10);
  std::set<TrackId> seen;
  for (const TrackId track : events[1].tracks) {
    EXPECT_TRUE(track == 0 || seen.insert(track).second);
  }
}

TEST(Frontend, VideoGivesLightFramesBetweenKeyframesAndIndicesWithoutGaps) {
  const auto events = EventsOf(SmallOptions(KeyframeMode::kParallax), 2.0, 12);
  ASSERT_EQ(events.size(), 12u);
  size_t num_keyframes = 0;
  for (size_t i = 0; i < events.size(); ++i) {
    EXPECT_EQ(events[i].id.index, i);
    EXPECT_EQ(events[i].tracks.size(), events[i].features->keypoints.size());
    num_keyframes += events[i].kind == FrameKind::kKeyframe;
    if (events[i].kind == FrameKind::kLight) {
      EXPECT_EQ(events[i].features->descriptors.Count(), 0u);
      EXPECT_TRUE(events[i].pairs.empty());
      EXPECT_GT(events[i].tracks.size(), 50u);
    }
  }
  EXPECT_GE(num_keyframes, 2u);
  EXPECT_LE(num_keyframes, 7u);
}

TEST(Frontend, GivesTheSameEventsWhenPreparedAhead) {
  const FrontendOptions options = SmallOptions(KeyframeMode::kParallax);
  const MovingImages images;
  std::vector<PreparedImage> prepared;
  for (int i = 5; i-- > 0;) {
    prepared.insert(prepared.begin(),
                    PrepareImage(MovingImages::Event(images.At(3.0 * i), i), options));
  }
  const auto expected = EventsOf(options, 3.0, 5);
  Frontend frontend(options, "rovio", 1, 5);
  for (size_t i = 0; i < prepared.size(); ++i) {
    const auto event = frontend.Add(prepared[i]);
    ASSERT_TRUE(event.has_value());
    EXPECT_EQ(event->tracks, expected[i].tracks);
    EXPECT_EQ(event->features->descriptors.data, expected[i].features->descriptors.data);
  }
}

TEST(Frontend, StartsADriveWhenTimeJumpsBackOrTheCameraChanges) {
  const MovingImages images;
  Frontend frontend(SmallOptions(KeyframeMode::kEvery), "rovio", 1, 5);
  const auto first = frontend.Add(MovingImages::Event(images.At(0), 4));
  ImageEvent back = MovingImages::Event(images.At(0), 4);
  back.stamp_ns -= 1'000'000'001;
  const auto looped = frontend.Add(back);
  ImageEvent other_camera = MovingImages::Event(images.At(0), 5);
  other_camera.camera.fx = 250.0;
  const auto recalibrated = frontend.Add(other_camera);
  ASSERT_TRUE(first && looped && recalibrated);
  EXPECT_EQ(first->id.drive.nonce, 5u);
  EXPECT_NE(looped->id.drive, first->id.drive);
  EXPECT_NE(recalibrated->id.drive, looped->id.drive);
  EXPECT_EQ(looped->id.index, 0u);
  EXPECT_TRUE(looped->pairs.empty());
  EXPECT_EQ(frontend.counters().drives, 3u);
}

TEST(Frontend, PassesOverRepeatedAndLateImagesAndGoesOn) {
  const MovingImages images;
  Frontend frontend(SmallOptions(KeyframeMode::kEvery), "rovio", 1, 5);
  const auto first = frontend.Add(MovingImages::Event(images.At(0), 4));
  EXPECT_FALSE(frontend.Add(MovingImages::Event(images.At(0), 4)).has_value());
  ImageEvent late = MovingImages::Event(images.At(8), 4);
  late.stamp_ns -= 1'000'000'000;
  EXPECT_FALSE(frontend.Add(late).has_value());
  EXPECT_NE(frontend.last_refusal().find("late"), std::string::npos) << frontend.last_refusal();
  const auto next = frontend.Add(MovingImages::Event(images.At(8), 5));
  ASSERT_TRUE(first && next);
  EXPECT_EQ(next->id.drive, first->id.drive);
  EXPECT_EQ(next->id.index, 1u);
  EXPECT_EQ(frontend.counters().late, 2u);
  EXPECT_EQ(frontend.counters().drives, 1u);
}

TEST(Frontend, TakesACameraWhoseLastDigitsDifferForTheDrives) {
  const MovingImages images;
  Frontend frontend(SmallOptions(KeyframeMode::kEvery), "rovio", 1, 5);
  ImageEvent rounded = MovingImages::Event(images.At(8), 1);
  rounded.camera.fx += 1e-9;
  const auto first = frontend.Add(MovingImages::Event(images.At(0), 0));
  const auto next = frontend.Add(rounded);
  ASSERT_TRUE(first && next);
  EXPECT_EQ(next->id.drive, first->id.drive);
  EXPECT_EQ(next->camera, first->camera);  // the first counts
}

TEST(Frontend, CountsAndNamesWhatItRefuses) {
  const MovingImages images;
  Frontend frontend(SmallOptions(KeyframeMode::kEvery), "rovio", 1, 5);
  ImageEvent broken = MovingImages::Event(images.At(0), 0);
  broken.encoded = std::make_shared<const std::vector<uint8_t>>(100, uint8_t{7});
  EXPECT_FALSE(frontend.Add(broken).has_value());
  EXPECT_EQ(frontend.last_refusal(), "no JPEG or PNG with a readable header");
  const cv::Mat black(240, 320, CV_8UC3, cv::Scalar::all(0));
  EXPECT_FALSE(frontend.Add(MovingImages::Event(black, 1)).has_value());
  EXPECT_EQ(frontend.counters().refused, 1u);
  EXPECT_EQ(frontend.counters().spoilt + frontend.counters().featureless, 1u);
  EXPECT_TRUE(frontend.Add(MovingImages::Event(images.At(0), 2)).has_value());
}

TEST(Frontend, NamesImagesWithoutTextureWhateverTheirColour) {
  for (const auto& colour : {cv::Scalar::all(0), cv::Scalar::all(255), cv::Scalar(40, 90, 160)}) {
    Frontend frontend(SmallOptions(KeyframeMode::kEvery), "rovio", 1, 5);
    const MovingImages images;
    EXPECT_TRUE(frontend.Add(MovingImages::Event(images.At(0), 0)));
    const cv::Mat picture(240, 320, CV_8UC3, colour);
    EXPECT_FALSE(frontend.Add(MovingImages::Event(picture, 1)));
    EXPECT_EQ(frontend.last_refusal(), "image is of one colour or far more blurred than its drive");
  }
}

TEST(Frontend, KeepsImagesOnlyWhenAsked) {
  FrontendOptions options = SmallOptions(KeyframeMode::kEvery);
  EXPECT_EQ(EventsOf(options, 8.0, 1).at(0).jpeg, nullptr);
  options.keep_images = true;
  EXPECT_NE(EventsOf(options, 8.0, 1).at(0).jpeg, nullptr);
}

// Events of `count` images, with other options from image `change_at` on.
std::vector<FrameEvent> EventsWithChange(const FrontendOptions& first, const FrontendOptions& then,
                                         double step_px, int count, int change_at) {
  const MovingImages images;
  Frontend frontend(first, "rovio", 1, 5);
  std::vector<FrameEvent> events;
  for (int i = 0; i < count; ++i) {
    EXPECT_TRUE(frontend.SetOptions(i < change_at ? first : then, nullptr));
    auto event = frontend.Add(MovingImages::Event(images.At(i * step_px), i));
    if (event) events.push_back(*event);
  }
  return events;
}

TEST(Frontend, ThresholdsHoldFromTheNextImageOnInTheSameDrive) {
  const FrontendOptions first = SmallOptions(KeyframeMode::kEvery);
  FrontendOptions then = first;
  then.recursion.max_frames = 1;
  then.track.same_feature_px = 0.0;
  const auto events = EventsWithChange(first, then, 8.0, 5, 3);
  ASSERT_EQ(events.size(), 5u);
  EXPECT_EQ(events[2].pairs.size(), 2u);
  EXPECT_EQ(events[4].pairs.size(), 1u);
  EXPECT_EQ(events[4].id.drive, events[0].id.drive);
  EXPECT_EQ(events[4].id.index, 4u);
}

TEST(Frontend, VideoGoesOnWhenEveryThresholdChanges) {
  const FrontendOptions first = SmallOptions(KeyframeMode::kParallax);
  FrontendOptions then = first;
  then.choose.min_flow_rad = 0.05;
  then.choose.sharpness_window = 3;
  then.choose.num_corners = 50;
  then.light.max_features = 60;
  then.light.flow.max_backward_error_px = 0.3;
  const auto events = EventsWithChange(first, then, 2.0, 12, 6);
  const auto unchanged = EventsOf(first, 2.0, 12);
  ASSERT_EQ(events.size(), 12u);
  EXPECT_EQ(events[5].tracks, unchanged[5].tracks);
  EXPECT_EQ(events[11].id.drive, events[0].id.drive);
}

TEST(Frontend, RefusedOptionsLeaveTheOldOnes) {
  const FrontendOptions options = SmallOptions(KeyframeMode::kEvery);
  Frontend frontend(options, "rovio", 1, 5);
  FrontendOptions other_type = options;
  other_type.extract.type = DescriptorType::kOrb;
  other_type.min_features = 99;
  std::string error;
  EXPECT_FALSE(frontend.SetOptions(other_type, &error));
  EXPECT_NE(error.find("extract.type"), std::string::npos) << error;
  EXPECT_EQ(frontend.options().min_features, options.min_features);
}

}  // namespace
}  // namespace rovio_sfm
