#include "rovio_sfm/recognition/place_recognizer.h"

#include <gtest/gtest.h>

#include <set>

#include "recognition/place_frames.h"
#include "rovio_sfm/scene/append_feature.h"
#include "rovio_sfm/scene/memory_frame_store.h"

namespace rovio_sfm {
namespace {

const DriveId kFirst{"first", 1, 1};
const DriveId kSecond{"second", 2, 1};
constexpr uint32_t kCams = 6;

class PlaceRecognizerTest : public testing::Test {
 protected:
  PlaceRecognizerTest() : hall_(1, kCams), attic_(2, kCams), cellar_(3, kCams) {}

  static PlaceRecognizerOptions Options() {
    PlaceRecognizerOptions options;
    options.recent_past.min_keyframes = 3;
    return options;
  }

  PlaceRecognizer Make(const PlaceRecognizerOptions& options = Options()) {
    return PlaceRecognizer(options, ModelOf({&hall_, &attic_, &cellar_}), &store_);
  }

  FrameEvent Event(const SyntheticRoom& room, const DriveId& drive, uint32_t index,
                   TrackId first_track = 1) {
    const FrameEvent event = room.EventOf({drive, index}, index % kCams, first_track);
    store_.Put(event.id, event.features);
    return event;
  }

  // Adds a pass through the room; returns what was matched.
  std::vector<PlaceMatch> Pass(const SyntheticRoom& room, const DriveId& drive, uint32_t begin,
                               PlaceRecognizer* places) {
    std::vector<PlaceMatch> all;
    for (uint32_t i = begin; i < begin + kCams; ++i) {
      for (PlaceMatch& match : places->Add(Event(room, drive, i, 1 + 1000 * begin))) {
        all.push_back(std::move(match));
      }
    }
    return all;
  }

  // Leaves a keyframe every third feature of those that it was known by.
  void Thin(const SyntheticRoom& room, const FrameId& id) {
    const auto whole = room.FeaturesOf(id.index % kCams);
    auto thin = std::make_shared<FrameFeatures>();
    thin->descriptors = whole->descriptors;
    thin->descriptors.data.clear();
    for (size_t i = 0; i < whole->keypoints.size(); i += 3) AppendFeature(*whole, i, thin.get());
    store_.Put(id, thin);
  }

  MemoryFrameStore store_;
  SyntheticRoom hall_, attic_, cellar_;
};

// A hundred large features of one room's first view, all of another's as small ones.
std::shared_ptr<const FrameFeatures> LargeAndSmall(const SyntheticRoom& large,
                                                   const SyntheticRoom& small) {
  auto features = std::make_shared<FrameFeatures>(*large.FeaturesOf(0));
  const size_t length = features->descriptors.length;
  features->keypoints.resize(100);
  features->colors.resize(100);
  features->descriptors.data.resize(100 * length);
  for (Keypoint& keypoint : features->keypoints) keypoint.size_px = 20.0f;
  const auto more = small.FeaturesOf(0);
  for (size_t i = 0; i < more->keypoints.size(); ++i) AppendFeature(*more, i, features.get());
  return features;
}

TEST_F(PlaceRecognizerTest, WordsAreOfTheLargestFeatures) {
  for (const int max_features : {100, 2000}) {
    PlaceRecognizerOptions options = Options();
    options.max_features = max_features;
    options.candidates.max_candidates = 1;
    PlaceRecognizer places = Make(options);
    Pass(hall_, kFirst, 0, &places);
    Pass(attic_, kSecond, 0, &places);
    const auto matches = places.QueryImage(LargeAndSmall(hall_, attic_), hall_.world().camera);
    ASSERT_EQ(matches.size(), 1u) << max_features;
    EXPECT_EQ(matches[0].pairs[0].other.drive, max_features == 100 ? kFirst : kSecond);
  }
}

TEST_F(PlaceRecognizerTest, SecondDriveIsMatchedWithTheFirstAndTheFramesAround) {
  PlaceRecognizer places = Make();
  EXPECT_TRUE(Pass(hall_, kFirst, 0, &places).empty());
  const std::vector<PlaceMatch> matches = places.Add(Event(hall_, kSecond, 2));
  ASSERT_EQ(matches.size(), 1u);
  EXPECT_EQ(matches[0].query, (FrameId{kSecond, 2}));
  EXPECT_EQ(matches[0].pairs.front().other, (FrameId{kFirst, 2}));
  EXPECT_GE(matches[0].pairs.size(), 3u);
  EXPECT_GT(matches[0].score, 0.0);
  EXPECT_GT(matches[0].probability, 0.0);
}

TEST_F(PlaceRecognizerTest, AMatchHasFramesBeforeAndAfterTheMatchedOne) {
  PlaceRecognizer places = Make();
  Pass(hall_, kFirst, 0, &places);
  const std::vector<PlaceMatch> matches = places.Add(Event(hall_, kSecond, 2));
  ASSERT_EQ(matches.size(), 1u);
  std::set<uint32_t> others;
  for (const OverlapPair& pair : matches[0].pairs) others.insert(pair.other.index);
  EXPECT_EQ(others.count(1), 1u);
  EXPECT_EQ(others.count(3), 1u);
}

TEST_F(PlaceRecognizerTest, RememberedFramesAreOfTheRecentPast) {
  PlaceRecognizer places = Make();
  for (uint32_t i = 0; i < 5; ++i) places.Remember(Event(hall_, kFirst, i));
  EXPECT_TRUE(places.Add(Event(hall_, kFirst, 5)).empty());
  EXPECT_EQ(places.counters().only_recent, 1u);
}

TEST_F(PlaceRecognizerTest, DriveDoesNotMatchItsRecentPast) {
  PlaceRecognizer places = Make();
  EXPECT_TRUE(Pass(hall_, kFirst, 0, &places).empty());
  EXPECT_EQ(places.counters().only_recent, kCams);
}

TEST_F(PlaceRecognizerTest, DriveMatchesAPlaceThatItReturnsTo) {
  PlaceRecognizer places = Make();
  Pass(hall_, kFirst, 0, &places);
  EXPECT_TRUE(Pass(attic_, kFirst, kCams, &places).empty());
  const std::vector<PlaceMatch> matches = Pass(hall_, kFirst, 2 * kCams, &places);
  ASSERT_EQ(matches.size(), kCams);
  EXPECT_LT(matches[0].pairs.front().other.index, kCams);
}

TEST_F(PlaceRecognizerTest, EachDriveMatchesOnceBest) {
  PlaceRecognizer places = Make();
  Pass(hall_, kFirst, 0, &places);
  Pass(attic_, kFirst, kCams, &places);
  Pass(hall_, kFirst, 2 * kCams, &places);
  Pass(hall_, {"third", 3, 1}, 0, &places);
  const uint64_t num_outdone = places.counters().outdone;
  const std::vector<PlaceMatch> matches = places.Add(Event(hall_, kSecond, 2));
  ASSERT_EQ(matches.size(), 2u);
  EXPECT_NE(matches[0].pairs.front().other.drive, matches[1].pairs.front().other.drive);
  EXPECT_EQ(places.counters().outdone, num_outdone + 1);
}

TEST_F(PlaceRecognizerTest, OfOneDriveTheFrameWithMostInliersIsMatched) {
  for (const uint32_t poor_pass : {0u, 2u}) {  // proposed before the rich one, and after it
    PlaceRecognizer places = Make();
    Pass(hall_, kFirst, 0, &places);
    Pass(attic_, kFirst, kCams, &places);
    Pass(hall_, kFirst, 2 * kCams, &places);
    for (uint32_t i = 0; i < kCams; ++i) Thin(hall_, {kFirst, poor_pass * kCams + i});
    const uint64_t num_outdone = places.counters().outdone;
    const std::vector<PlaceMatch> matches = places.Add(Event(hall_, kSecond, 2));
    ASSERT_EQ(matches.size(), 1u);
    EXPECT_EQ(places.counters().outdone, num_outdone + 1);
    EXPECT_EQ(matches[0].pairs.front().other.index / kCams, 2 - poor_pass);
  }
}

TEST_F(PlaceRecognizerTest, ForeignRoomIsRefusedAndCounted) {
  PlaceRecognizer places = Make();
  Pass(hall_, kFirst, 0, &places);
  EXPECT_TRUE(Pass(attic_, kSecond, 0, &places).empty());
  const PlaceCounters& counters = places.counters();
  EXPECT_EQ(counters.low_score + counters.candidates, kCams);
  EXPECT_EQ(counters.refused_geometry, counters.candidates);
  EXPECT_EQ(counters.matched_queries, 0u);
}

TEST_F(PlaceRecognizerTest, ForeignDescriptorsAreRefusedWithTheReason) {
  PlaceRecognizer places = Make();
  FrameEvent event = Event(hall_, kFirst, 0);
  auto features = std::make_shared<FrameFeatures>(*event.features);
  features->descriptors.type = DescriptorType::kOrb;
  event.features = features;
  EXPECT_TRUE(places.Add(event).empty());
  EXPECT_EQ(places.counters().foreign_type, 1u);
  EXPECT_NE(places.last_refusal().find("first-1-1/0"), std::string::npos) << places.last_refusal();
  EXPECT_EQ(places.index().NumPlaces(), 0u);
}

TEST_F(PlaceRecognizerTest, LightFramesAndKnownOnesAreIgnored) {
  PlaceRecognizer places = Make();
  FrameEvent event = Event(hall_, kFirst, 0);
  places.Add(event);
  places.Add(event);
  event.kind = FrameKind::kLight;
  places.Add(event);
  EXPECT_EQ(places.counters().out_of_order, 1u);
  EXPECT_EQ(places.counters().light_frames, 1u);
  EXPECT_EQ(places.index().NumPlaces(), 1u);
}

TEST_F(PlaceRecognizerTest, FramesWithoutFeaturesInTheStoreAreOutOfReach) {
  PlaceRecognizer places = Make();
  places.Remember(hall_.EventOf({kFirst, 0}, 0, 1));
  EXPECT_TRUE(places.Add(Event(hall_, kSecond, 0)).empty());
  EXPECT_EQ(places.counters().out_of_reach, 1u);
}

TEST_F(PlaceRecognizerTest, RememberedFramesAreMatchedLater) {
  PlaceRecognizer places = Make();
  places.Remember(Event(hall_, kFirst, 0));
  EXPECT_EQ(places.counters().queries, 0u);
  EXPECT_EQ(places.Add(Event(hall_, kSecond, 0)).size(), 1u);
}

TEST_F(PlaceRecognizerTest, OverlapsOfTwoDrivesAreFoundInEitherDirection) {
  PlaceRecognizer places = Make();
  std::vector<FrameId> first, second;
  for (uint32_t i = 0; i < kCams; ++i) {
    first.push_back({kFirst, i});
    second.push_back({kSecond, i});
    places.Remember(Event(hall_, kFirst, i));
    places.Remember(Event(i < 3 ? hall_ : attic_, kSecond, i));
  }
  EXPECT_EQ(places.FindOverlaps(second, first).size(), 3u);
  EXPECT_GE(places.FindOverlaps(first, second).size(), 3u);
}

TEST_F(PlaceRecognizerTest, OverlapsOfOneDriveLeaveOutNeighbors) {
  PlaceRecognizer places = Make();
  std::vector<FrameId> frames;
  for (uint32_t i = 0; i < 2 * kCams; ++i) {
    frames.push_back({kFirst, i});
    places.Remember(Event(hall_, kFirst, i));
  }
  const std::vector<PlaceMatch> matches = places.FindOverlaps(frames, frames);
  EXPECT_FALSE(matches.empty());
  for (const PlaceMatch& match : matches) {
    const int gap =
        static_cast<int>(match.pairs.front().other.index) - static_cast<int>(match.query.index);
    EXPECT_GT(std::abs(gap), 3);
  }
}

TEST_F(PlaceRecognizerTest, OverlapsOfOneDriveMayBeNearWhereTheOtherIsNoQuery) {
  PlaceRecognizer places = Make();
  for (uint32_t i = 0; i < kCams; ++i) places.Remember(Event(hall_, kFirst, i));
  const auto matches = places.FindOverlaps({{kFirst, 2}}, {{kFirst, 2}, {kFirst, 3}});
  ASSERT_EQ(matches.size(), 1u);
  EXPECT_EQ(matches[0].pairs.front().other, (FrameId{kFirst, 3}));
}

TEST_F(PlaceRecognizerTest, ImageIsFoundButNotRemembered) {
  PlaceRecognizer places = Make();
  Pass(hall_, kFirst, 0, &places);
  const auto matches = places.QueryImage(hall_.FeaturesOf(3), hall_.world().camera);
  ASSERT_EQ(matches.size(), 1u);
  EXPECT_EQ(matches[0].pairs.front().other, (FrameId{kFirst, 3}));
  EXPECT_EQ(places.index().NumPlaces(), kCams);
}

TEST_F(PlaceRecognizerTest, SameCallsGiveTheSameMatches) {
  PlaceRecognizer once = Make(), again = Make();
  for (uint32_t i = 0; i < kCams; ++i) {  // interleaved drives
    for (const DriveId& drive : {kFirst, kSecond}) {
      const auto a = once.Add(Event(hall_, drive, i));
      const auto b = again.Add(Event(hall_, drive, i));
      ASSERT_EQ(a.size(), b.size());
      for (size_t j = 0; j < a.size(); ++j) {
        EXPECT_EQ(a[j].score, b[j].score);
        EXPECT_EQ(a[j].pairs.front().other, b[j].pairs.front().other);
        EXPECT_EQ(a[j].pairs.front().query_from_other.rotation.coeffs(),
                  b[j].pairs.front().query_from_other.rotation.coeffs());
      }
    }
  }
  EXPECT_GT(once.counters().matched_queries, 0u);
}

}  // namespace
}  // namespace rovio_sfm
