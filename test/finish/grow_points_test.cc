#include "rovio_sfm/finish/grow_points.h"

#include <gtest/gtest.h>

#include "finish/small_model.h"

namespace rovio_sfm {
namespace {

using Tracks = std::vector<std::vector<ModelView>>;

// The room without its points: their views as tracks, and where they truly are.
struct Unseen {
  MapModel model = SmallRoom(5);
  Tracks tracks;
  std::vector<Eigen::Vector3d> truth;

  explicit Unseen(size_t num_kept = 0) {
    for (const ModelPoint& point : model.points) {
      tracks.push_back(point.views);
      truth.push_back(point.x_in_map);
    }
    model.points.resize(num_kept);
  }
};

// Several degrees are seen of the nearest points alone.
GrowOptions AnyParallax() {
  GrowOptions options;
  options.triangulate.min_parallax_rad = 1e-3;
  return options;
}

TEST(AddPoints, MakesThePointsOfTracks) {
  Unseen room;
  EXPECT_EQ(AddPoints(room.tracks, AnyParallax(), &room.model), 0u);
  ASSERT_EQ(room.model.points.size(), room.truth.size());
  for (size_t i = 0; i < room.truth.size(); ++i) {
    EXPECT_LT((room.model.points[i].x_in_map - room.truth[i]).norm(), 1e-6);
    EXPECT_EQ(room.model.points[i].views.size(), 5u);
  }
}

TEST(AddPoints, GivesFreeViewsToThePointOfTheirTrack) {
  Unseen room(1);
  room.model.points[0].views.resize(2);
  AddPoints({room.tracks[0]}, AnyParallax(), &room.model);
  ASSERT_EQ(room.model.points.size(), 1u);
  EXPECT_EQ(room.model.points[0].views.size(), 5u);
}

TEST(AddPoints, MakesTwoPointsOfATrackThatHoldsTwo) {
  Unseen room;
  const auto &a = room.tracks[0], &b = room.tracks[40];
  AddPoints({{a[0], a[1], b[2], b[3], b[4]}}, AnyParallax(), &room.model);
  ASSERT_EQ(room.model.points.size(), 2u);
  EXPECT_EQ(room.model.points[0].views.size(), 3u);
  EXPECT_LT((room.model.points[0].x_in_map - room.truth[40]).norm(), 1e-6);
  EXPECT_LT((room.model.points[1].x_in_map - room.truth[0]).norm(), 1e-6);
}

TEST(AddPoints, TellsTracksThatGiveNoPoint) {
  Unseen room;
  GrowOptions options;
  options.triangulate.min_parallax_rad = 1.0;
  EXPECT_EQ(AddPoints({room.tracks[0]}, options, &room.model), 1u);
  options = AnyParallax();
  options.min_views = 6;
  EXPECT_EQ(AddPoints({room.tracks[0]}, options, &room.model), 1u);
  EXPECT_TRUE(room.model.points.empty());
}

TEST(AdjustPoints, MovesPointsToWhereTheyAreSeen) {
  Unseen room;
  AddPoints(room.tracks, AnyParallax(), &room.model);
  for (ModelPoint& point : room.model.points) point.x_in_map.z() += 0.005;
  EXPECT_EQ(AdjustPoints(0, AnyParallax(), &room.model), 0u);
  for (size_t i = 0; i < room.truth.size(); ++i) {
    EXPECT_LT((room.model.points[i].x_in_map - room.truth[i]).norm(), 1e-3);
  }
}

TEST(AdjustPoints, DropsBadViewsAndWhatIsLeftWithTooFew) {
  Unseen room(3);
  room.model.points[2].views = {room.tracks[2][0], room.tracks[60][1]};  // of two points
  const MapModel before = room.model;
  EXPECT_EQ(AdjustPoints(2, AnyParallax(), &room.model), 1u);
  EXPECT_EQ(room.model.points.size(), 2u);
  room.model = before;
  EXPECT_EQ(AdjustPoints(3, AnyParallax(), &room.model), 0u);  // one that was there stays
  EXPECT_EQ(room.model.points[2].x_in_map, before.points[2].x_in_map);
}

}  // namespace
}  // namespace rovio_sfm
