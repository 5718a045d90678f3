#include "rovio_sfm/report/collect_model.h"

#include <gtest/gtest.h>

#include "rovio_sfm/scene/memory_frame_store.h"
#include "synthetic/two_sessions.h"

namespace rovio_sfm {
namespace {

// Two exactly mapped sessions, of two drives and in two gauges, that are one map: session 1's, two
// metres a unit. Points that both see are linked.
struct TwoSessionMap {
  TwoSessionMap() : two(MakeTwoSessions({})) {
    sessions.Adopt(two.a);
    sessions.Adopt(two.b);
    AddToSnapshot(two.a, two.world_a, {});
    AddToSnapshot(two.b, two.world_b, Inverse(two.b_from_a));
    snapshot.sessions[0].scale = MapScale{2.0, 0.01, "odometry"};
    auto shared = std::make_shared<SharedLandmarks>();
    for (const auto& [id, landmark] : two.a.landmarks()) {
      if (two.b.FindLandmark(id) == nullptr) continue;
      (*shared)[{two.a.id(), id}] = (*shared)[{two.b.id(), id}] = static_cast<uint32_t>(id);
    }
    snapshot.shared_landmarks[{1}] = shared;
  }

  void AddToSnapshot(const Session& session, const SyntheticWorld& world,
                     const Sim3& map_from_session) {
    snapshot.sessions.push_back(session.Snapshot());
    snapshot.sessions.back().map = {1};
    snapshot.sessions.back().map_from_session = map_from_session;
    for (uint32_t i = 0; i < world.views.size(); ++i) {
      store.Put({session.drive(), i},
                std::make_shared<const FrameFeatures>(MakeFeatures(world, i)));
    }
  }

  MapModel Collect() const { return CollectModel(*FindLevelMap(snapshot, {1}), sessions, store); }

  TwoSessions two;
  SessionTable sessions;
  MemoryFrameStore store;
  MapSnapshot snapshot;
};

TEST(CollectModel, ShowsPicturesThroughTheCameraThatASessionFound) {
  TwoSessionMap map;
  Session* session = map.sessions.Lend({1});
  const Camera found = CorrectedCamera(session->camera(), {0.004, -0.003, 0.002});
  ASSERT_TRUE(session->SetCamera(found));
  const MapModel model = map.Collect();
  const ModelImage& image = model.images[0];
  EXPECT_TRUE(model.cameras[image.camera] == found);
  for (const Keypoint& keypoint : image.keypoints) {
    const Eigen::Vector2d x_px = PixelFromNormalized(found, keypoint.x_normalized);
    EXPECT_LT((x_px - Eigen::Vector2d(keypoint.x_px, keypoint.y_px)).norm(), 1e-3);
  }
}

TEST(CollectModel, EveryViewIsWhereItsPointProjects) {
  const TwoSessionMap map;
  const MapModel model = map.Collect();
  EXPECT_EQ(model.length_unit, "metres");
  EXPECT_EQ(model.cameras.size(), 2u);
  ASSERT_EQ(model.images.size(), 8u);
  size_t num_views = 0;
  for (const ModelPoint& point : model.points) {
    for (const ModelView& view : point.views) {
      const ModelImage& image = model.images[view.image];
      const Keypoint& keypoint = image.keypoints[view.keypoint];
      const Eigen::Vector2d seen = (image.cam_from_map * point.x_in_map).hnormalized();
      EXPECT_LT((seen - keypoint.x_normalized).norm(), 1e-9);
      const Eigen::Vector2d x_px = PixelFromNormalized(model.cameras[image.camera], seen);
      EXPECT_LT((x_px - Eigen::Vector2d(keypoint.x_px, keypoint.y_px)).norm(), 1e-3);
      ++num_views;
    }
  }
  EXPECT_GT(num_views, 500u);
}

TEST(CollectModel, HasThePointsOfTheCloudInItsOrder) {
  const TwoSessionMap map;
  const MapModel model = map.Collect();
  const std::vector<CloudPoint> cloud = LevelCloud(*FindLevelMap(map.snapshot, {1}));
  ASSERT_EQ(model.points.size(), cloud.size());
  for (size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_EQ(model.points[i].x_in_map, cloud[i].x_in_map);
    EXPECT_EQ(model.points[i].views.size(), cloud[i].num_views);
  }
}

TEST(CollectModel, LinkedLandmarksAreOnePointSeenByBothSessions) {
  TwoSessionMap map;
  const MapModel joined = map.Collect();
  size_t num_across = 0;
  for (const ModelPoint& point : joined.points) {
    const auto of_drive = [&](size_t view) {
      return joined.images[point.views[view].image].id.drive;
    };
    num_across += of_drive(0) != of_drive(point.views.size() - 1) ? 1 : 0;
    for (size_t i = 1; i < point.views.size(); ++i) {
      EXPECT_LT(point.views[i - 1].image, point.views[i].image);
    }
  }
  EXPECT_GT(num_across, 100u);
  map.snapshot.shared_landmarks.clear();
  EXPECT_GT(map.Collect().points.size(), joined.points.size() + 100);
}

TEST(CollectModel, LeavesOutWeakFrames) {
  TwoSessionMap map;
  Session* session = map.sessions.Lend({1});
  const std::vector<TrackId> tracks = session->keyframe(1).tracks;
  for (uint32_t i = 0; i < tracks.size(); ++i) {
    if (session->FindLandmark(tracks[i]) != nullptr) session->RemoveObservation(tracks[i], {1, i});
  }
  session->SetWeak(1, true);
  map.snapshot.sessions[0].landmarks = session->Snapshot().landmarks;
  map.snapshot.sessions[0].frames = session->Snapshot().frames;
  const MapModel model = map.Collect();
  ASSERT_EQ(model.images.size(), 7u);
  EXPECT_EQ(model.images[1].id.index, 2u);
}

TEST(CollectModel, NamesAFrameWhoseFeaturesAreNotThere) {
  TwoSessionMap map;
  map.store = MemoryFrameStore();
  std::string error;
  try {
    map.Collect();
  } catch (const std::runtime_error& thrown) {
    error = thrown.what();
  }
  EXPECT_NE(error.find(map.two.a.drive().ToString() + "/0"), std::string::npos) << error;
}

}  // namespace
}  // namespace rovio_sfm
