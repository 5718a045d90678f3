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

// The session with the landmark of a track moved, and all views of it with it.
Session WithMovedTrack(const Session& session, TrackId id, const Eigen::Vector3d& shift) {
  Session moved(session.id(), session.drive(), session.camera());
  const Landmark& landmark = session.landmarks().at(id);
  for (const auto& [index, keyframe] : session.keyframes()) {
    Keyframe frame = keyframe;
    frame.observed.assign(frame.observed.size(), 0);
    frame.num_observed = 0;
    frame.sigmas.assign(frame.sigmas.size(), 1.0 / session.camera().MeanFocal());
    for (const Observation& view : landmark.observations) {
      if (view.frame != index) continue;
      frame.points[view.feature] =
          (frame.cam_from_session * (landmark.position + shift)).hnormalized();
    }
    moved.AddKeyframe(index, frame);
  }
  for (const auto& [track, one] : session.landmarks()) {
    moved.AddLandmark(track, one.position, one.color, one.observations);
  }
  moved.SetPosition(id, landmark.position + shift);
  return moved;
}

TEST(TryUniteLandmarks, AsksTheViewsOfBothLandmarks) {
  const SyntheticDrive drive = CutDrive();
  const Session session = MappedDrive(drive);
  const Eigen::Vector3d shift(0.0, 0.05, 0.0);  // three quarters of it are too much for a view
  for (const TrackLink& link : AllLinks(drive)) {
    const Landmark *a = session.FindLandmark(link.a), *b = session.FindLandmark(link.b);
    if (a == nullptr || b == nullptr) continue;
    if (a->observations.size() != 2 || b->observations.size() != 4) continue;
    Session few_moved = WithMovedTrack(session, session.RootOf(link.a), shift);
    EXPECT_FALSE(TryUniteLandmarks(link.a, link.b, {}, &few_moved));
    EXPECT_FALSE(TryUniteLandmarks(link.b, link.a, {}, &few_moved));
    FilterF2Options wide;
    wide.max_chi_square = 1000.0;
    EXPECT_TRUE(TryUniteLandmarks(link.a, link.b, wide, &few_moved));
    EXPECT_EQ(CheckInvariants(few_moved), "");
    return;
  }
  FAIL() << "no link of a landmark of two views and one of four";
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
