#include "rovio_sfm/mapping/link_tracks.h"

#include <gtest/gtest.h>

#include "mapping/mapped_drive.h"

namespace rovio_sfm {
namespace {

// Every point's track is cut after four frames; links join the parts.
SyntheticDrive CutDrive() {
  SyntheticDriveOptions options;
  options.track_length = 4;
  options.with_links = true;
  return MakeSyntheticDrive(options);
}

std::vector<TrackLink> AllLinks(const SyntheticDrive& drive) {
  std::vector<TrackLink> links;
  for (const FrameEvent& event : drive.events) {
    links.insert(links.end(), event.links.begin(), event.links.end());
  }
  return links;
}

TEST(LinkTracks, JoinsTheTracksAndLandmarksOfOnePoint) {
  const SyntheticDrive drive = CutDrive();
  Session session = MappedDrive(drive);
  const size_t num_landmarks = session.landmarks().size();
  auto links = AllLinks(drive);
  const LinkReport report = LinkTracks({}, &links, &session);
  EXPECT_EQ(report.num_united, AllLinks(drive).size());
  EXPECT_EQ(report.num_refused_f1, 0u);
  EXPECT_TRUE(links.empty());
  EXPECT_LT(session.landmarks().size(), num_landmarks / 2);
  EXPECT_EQ(CheckInvariants(session), "");
  for (const auto& [id, landmark] : session.landmarks()) {
    const uint32_t point = PointOf(drive, landmark.observations[0]);
    EXPECT_LT((landmark.position - drive.world.points[point]).norm(), 1e-9);
  }
}

TEST(LinkTracks, RefusesByF1TwoFeaturesOfOneFrame) {
  const SyntheticDrive drive = MakeSyntheticDrive({});
  Session session = MappedDrive(drive, 4);
  std::vector<TrackLink> links = {{session.keyframe(0).tracks[0], session.keyframe(0).tracks[1]}};
  const size_t num_landmarks = session.landmarks().size();
  EXPECT_EQ(LinkTracks({}, &links, &session).num_refused_f1, 1u);
  EXPECT_TRUE(links.empty());
  EXPECT_EQ(session.landmarks().size(), num_landmarks);
}

TEST(LinkTracks, KeepsWhatFailsF2AndUnitesItOnceItAgrees) {
  const SyntheticDrive drive = CutDrive();
  Session session = MappedDrive(drive);
  TrackLink link = {0, 0};
  for (const TrackLink& one : AllLinks(drive)) {
    if (session.FindLandmark(one.a) != nullptr && session.FindLandmark(one.b) != nullptr)
      link = one;
  }
  ASSERT_NE(link.a, 0u);
  const Eigen::Vector3d truth = session.FindLandmark(link.a)->position;
  session.SetPosition(link.a, truth + Eigen::Vector3d(0.5, 0.0, 0.0));
  std::vector<TrackLink> links = {link};
  EXPECT_EQ(LinkTracks({}, &links, &session).num_united, 0u);
  ASSERT_EQ(links.size(), 1u);
  session.SetPosition(link.a, truth);
  EXPECT_EQ(LinkTracks({}, &links, &session).num_united, 1u);
  EXPECT_TRUE(links.empty());
}

TEST(LinkTracks, RemembersLinksOfTracksNotSeenYet) {
  const SyntheticDrive drive = MakeSyntheticDrive({});
  Session session({1}, drive.events[0].id.drive, drive.world.camera);
  std::vector<TrackLink> links = {{5, 4}, {4, 3}};
  EXPECT_EQ(LinkTracks({}, &links, &session).num_united, 2u);
  EXPECT_EQ(session.RootOf(5), 3u);
}

TEST(TryUniteLandmarks, WeighsByTheNumberOfViews) {
  const SyntheticDrive drive = CutDrive();
  Session session = MappedDrive(drive);
  for (const TrackLink& link : AllLinks(drive)) {
    const Landmark *a = session.FindLandmark(link.a), *b = session.FindLandmark(link.b);
    if (a == nullptr || b == nullptr || a->observations.size() != 2) continue;
    const double weight_b = static_cast<double>(b->observations.size()) - 1.0;
    const Eigen::Vector3d truth = a->position;
    session.SetPosition(session.RootOf(link.a), truth + Eigen::Vector3d(0.001, 0, 0));
    ASSERT_TRUE(TryUniteLandmarks(link.a, link.b, {}, &session));
    const double moved = session.FindLandmark(link.a)->position.x() - truth.x();
    EXPECT_NEAR(moved, 0.001 / (1.0 + weight_b), 1e-9);
    return;
  }
  FAIL() << "no link of two landmarks";
}

TEST(TryUniteLandmarks, RefusesTracksWithoutLandmarksAndOneWithItself) {
  const SyntheticDrive drive = CutDrive();
  Session session = MappedDrive(drive);
  const TrackId id = session.landmarks().begin()->first;
  EXPECT_FALSE(TryUniteLandmarks(id, id, {}, &session));
  EXPECT_FALSE(TryUniteLandmarks(id, 99999999, {}, &session));
}

}  // namespace
}  // namespace rovio_sfm
