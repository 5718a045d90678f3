#include "rovio_sfm/mapping/search_landmarks.h"

#include <gtest/gtest.h>

#include "mapping/mapped_drive.h"
#include "rovio_sfm/sfm/triangulate_tracks.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kNewest = 8;

// Every point's track is cut after four frames; nothing links the parts.
SyntheticDrive CutDrive(double noise_px = 0.0) {
  SyntheticDriveOptions options;
  options.world.noise_px = noise_px;
  options.track_length = 4;
  return MakeSyntheticDrive(options);
}

// Frames 0 to 7 mapped, frame 8 just registered.
Session GrownDrive(const SyntheticDrive& drive) {
  Session session = MappedDrive(drive, kNewest);
  const Rigid3& pose = drive.world.cams_from_map[kNewest];
  session.AddKeyframe(kNewest, MakeKeyframe(drive.events[kNewest], pose, {}));
  CompleteLandmarks(kNewest, 4.0, &session);
  return session;
}

// The drive's features with other descriptors in the newest frame.
MemoryFrameStore StoreWith(const SyntheticDrive& drive, const Descriptors& descriptors) {
  MemoryFrameStore store = StoreOf(drive);
  auto features = std::make_shared<FrameFeatures>(*drive.events[kNewest].features);
  features->descriptors = descriptors;
  store.Put(drive.events[kNewest].id, features);
  return store;
}

size_t NumFalseObservations(const SyntheticDrive& drive, const Session& session) {
  size_t count = 0;
  for (const auto& [id, landmark] : session.landmarks()) {
    for (const Observation& observation : landmark.observations) {
      count += PointOf(drive, observation) != PointOf(drive, landmark.observations[0]) ? 1 : 0;
    }
  }
  return count;
}

TEST(SearchLandmarks, FindsTheFeaturesOfCutTracks) {
  for (const double noise_px : {0.0, 0.7}) {
    const SyntheticDrive drive = CutDrive(noise_px);
    Session session = GrownDrive(drive);
    const uint32_t before = session.keyframe(kNewest).num_observed;
    const SearchReport report = SearchLandmarks(kNewest, {}, StoreOf(drive), &session);
    EXPECT_GT(report.num_candidates, 20u);
    EXPECT_GT(report.num_added, 20u);
    EXPECT_EQ(session.keyframe(kNewest).num_observed, before + report.num_added);
    EXPECT_EQ(NumFalseObservations(drive, session), 0u);
    EXPECT_EQ(CheckInvariants(session), "");
  }
}

TEST(SearchLandmarks, UnitesLandmarksOfOnePoint) {
  const SyntheticDrive drive = CutDrive();
  Session session = MappedDrive(drive);
  const size_t before = session.landmarks().size();
  const SearchReport report = SearchLandmarks(kNewest, {}, StoreOf(drive), &session);
  EXPECT_GT(report.num_united, 20u);
  EXPECT_EQ(session.landmarks().size(), before - report.num_united);
  EXPECT_EQ(NumFalseObservations(drive, session), 0u);
  EXPECT_EQ(CheckInvariants(session), "");
}

TEST(SearchLandmarks, UnitesOnlyWhatPassesF2) {
  const SyntheticDrive drive = CutDrive(0.7);
  Session session = MappedDrive(drive);
  const size_t before = session.landmarks().size();
  SearchLandmarksOptions options;
  options.f2.max_chi_square = 1e-6;
  EXPECT_EQ(SearchLandmarks(kNewest, options, StoreOf(drive), &session).num_united, 0u);
  EXPECT_EQ(session.landmarks().size(), before);
  EXPECT_GT(SearchLandmarks(kNewest, {}, StoreOf(drive), &session).num_united, 20u);
}

TEST(SearchLandmarks, AddsNothingThatLooksDifferent) {
  const SyntheticDrive drive = CutDrive();
  Session session = GrownDrive(drive);
  Descriptors other = drive.events[kNewest].features->descriptors;
  for (uint8_t& byte : other.data) byte = static_cast<uint8_t>(200 - byte);
  const SearchReport report = SearchLandmarks(kNewest, {}, StoreWith(drive, other), &session);
  EXPECT_GT(report.num_candidates, 20u);
  EXPECT_EQ(report.num_added + report.num_united, 0u);
}

TEST(SearchLandmarks, AddsNothingOutsideTheWindow) {
  const SyntheticDrive drive = CutDrive();
  Session session = GrownDrive(drive);
  Rigid3 turned = drive.world.cams_from_map[kNewest];
  turned.rotation = Eigen::AngleAxisd(0.05, Eigen::Vector3d::UnitY()) * turned.rotation;
  session.SetPose(kNewest, turned);
  const SearchReport report = SearchLandmarks(kNewest, {}, StoreOf(drive), &session);
  EXPECT_EQ(report.num_added + report.num_united, 0u);
}

TEST(SearchLandmarks, LeavesFramesWithoutDescriptorsAlone) {
  const SyntheticDrive drive = CutDrive();
  Session session = GrownDrive(drive);
  EXPECT_EQ(SearchLandmarks(kNewest, {}, MemoryFrameStore(), &session).num_candidates, 0u);
  EXPECT_EQ(SearchLandmarks(kNewest, {}, StoreWith(drive, {}), &session).num_candidates, 0u);
  Descriptors binary = drive.events[kNewest].features->descriptors;
  binary.metric = DescriptorMetric::kHamming;
  EXPECT_EQ(SearchLandmarks(kNewest, {}, StoreWith(drive, binary), &session).num_candidates, 0u);
}

TEST(SearchLandmarks, ComparesNoDescriptorsOfAnotherLength) {
  const SyntheticDrive drive = CutDrive();
  Session session = GrownDrive(drive);
  Descriptors longer = drive.events[kNewest].features->descriptors;
  longer.length *= 2;
  longer.data.resize(2 * longer.data.size());
  EXPECT_EQ(SearchLandmarks(kNewest, {}, StoreWith(drive, longer), &session).num_candidates, 0u);
}

}  // namespace
}  // namespace rovio_sfm
