#include "rovio_sfm/ros/map_finisher.h"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>

#include "finish/wall_model.h"
#include "report/small_map.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

constexpr MapId kMap = {1};

// What brought the pictures of the wall, without features.
std::map<FrameId, FrameEventMsg::ConstPtr> EventsOfWall() {
  std::map<FrameId, FrameEventMsg::ConstPtr> events;
  for (const ModelImage& image : WallModel().images) {
    const auto event = boost::make_shared<FrameEventMsg>();
    event->jpeg = *ReadWall(image);
    events[image.id] = event;
  }
  return events;
}

// The wall as map 1, metric; what the world may see of it is `now_`.
class MapFinisherTest : public testing::Test {
 protected:
  MapFinisherTest() {
    MapSnapshot snapshot = *SmallMaps(1);
    snapshot.sessions[0].scale = MapScale{1.0, 0.01, "odometry"};
    now_.snapshot = std::make_shared<const MapSnapshot>(snapshot);
    sources_.take = [this](uint32_t session) {
      asked_ = session;
      return TakenMap{{}, now_, *GaugeOf(now_, kMap), WallModel()};
    };
    sources_.picture = [this] { return now_; };
    sources_.frames = [] { return KeptFrames(EventsOfWall(), ""); };
    sources_.output_dir = folder_.Path().string();
  }

  DensifyResult Densify(const std::string& name = "", const std::string& method = "depth") {
    DensifyGoal goal;
    goal.map = 1;
    goal.method = method;
    goal.name = name;
    return MapFinisher(sources_, &shelf_).Densify(goal, progress_);
  }
  ReconstructSurfaceResult ReconstructSurface(const std::string& source) {
    ReconstructSurfaceGoal goal;
    goal.source = source;
    goal.name = "finished";
    return MapFinisher(sources_, &shelf_).ReconstructSurface(goal, progress_);
  }
  MapProducts Shown() { return shelf_.Fitting(now_)[kMap]; }

  const TemporaryFolder folder_;
  MapPicture now_;
  FinishSources sources_;
  ProductShelf shelf_;
  uint32_t asked_ = 0;
  std::vector<size_t> told_;  // num_done
  GoalProgress progress_ = [this](const std::string&, size_t num_done, size_t) {
    told_.push_back(num_done);
    return true;
  };
};

TEST_F(MapFinisherTest, DensifiesByDepthAndWritesTheCloud) {
  const DensifyResult result = Densify("finished");
  ASSERT_EQ(result.status.code, Status::OK) << result.status.message;
  EXPECT_EQ(asked_, 1u);
  EXPECT_EQ(result.map, 1u);
  EXPECT_GT(result.num_points, 2000u);
  // Five keyframes, each estimated and checked.
  EXPECT_EQ(told_, (std::vector<size_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
  EXPECT_EQ(result.file, (folder_.Path() / "finished/dense.ply").string());
  EXPECT_TRUE(std::filesystem::exists(result.file));
  ASSERT_TRUE(Shown().dense);
  EXPECT_EQ(Shown().dense->size(), result.num_points);
  ASSERT_TRUE(Shown().grid);
  EXPECT_GT(Shown().grid->width, 0);
  EXPECT_EQ(Densify("finished").status.code, Status::ALREADY_EXISTS);
}

TEST_F(MapFinisherTest, WritesNothingWithoutAName) {
  const DensifyResult result = Densify();
  EXPECT_EQ(result.status.code, Status::OK);
  EXPECT_EQ(result.file, "");
  EXPECT_TRUE(std::filesystem::is_empty(folder_.Path()));
}

TEST_F(MapFinisherTest, EndsWhenItsGoalIsCancelled) {
  progress_ = [](const std::string&, size_t num_done, size_t) { return num_done < 2; };
  EXPECT_EQ(Densify("finished").status.code, Status::CANCELLED);
  EXPECT_FALSE(Shown().dense);
  EXPECT_FALSE(std::filesystem::exists(folder_.Path() / "finished"));
}

TEST_F(MapFinisherTest, RefusesWhatWasMadeOfAnOlderRevision) {
  progress_ = [this](const std::string&, size_t, size_t) {
    ++now_.epoch;
    return true;
  };
  const DensifyResult result = Densify("finished");
  EXPECT_EQ(result.status.code, Status::FAILED_PRECONDITION);
  EXPECT_NE(result.status.message.find("map 1 was merged"), std::string::npos)
      << result.status.message;
  EXPECT_FALSE(Shown().dense);
}

TEST_F(MapFinisherTest, SaysThatNoDescriptorsAreKept) {
  const DensifyResult result = Densify("", "matches");
  EXPECT_EQ(result.status.code, Status::FAILED_PRECONDITION);
  EXPECT_NE(result.status.message.find("no descriptors"), std::string::npos)
      << result.status.message;
}

TEST_F(MapFinisherTest, SaysThatNoPicturesAreKept) {
  sources_.frames = [] { return KeptFrames({}, ""); };
  const DensifyResult result = Densify();
  EXPECT_EQ(result.status.code, Status::FAILED_PRECONDITION);
  EXPECT_NE(result.status.message.find("keep_images"), std::string::npos) << result.status.message;
}

TEST_F(MapFinisherTest, RefusesWhatItDoesNotKnow) {
  const DensifyResult method = Densify("", "magic");
  EXPECT_EQ(method.status.code, Status::INVALID_ARGUMENT);
  EXPECT_NE(method.status.message.find("method = magic: "), std::string::npos);
  EXPECT_EQ(ReconstructSurface("").status.code, Status::INVALID_ARGUMENT);
  EXPECT_EQ(Densify("../out").status.code, Status::INVALID_ARGUMENT);
  EXPECT_TRUE(told_.empty());
}

TEST_F(MapFinisherTest, ReconstructsTheSurfaceThroughTheDenseCloud) {
  const ReconstructSurfaceResult result = ReconstructSurface("dense");
  ASSERT_EQ(result.status.code, Status::OK) << result.status.message;
  EXPECT_GT(result.num_triangles, 1000u);
  EXPECT_EQ(result.file, (folder_.Path() / "finished/mesh.ply").string());
  ASSERT_TRUE(Shown().surface && Shown().dense);
  EXPECT_EQ(Shown().surface->triangles.size(), result.num_triangles);
  EXPECT_EQ(Shown().dense->size(), result.num_points);
}

TEST_F(MapFinisherTest, SaysThatTooFewLandmarksMakeNoSurface) {
  const ReconstructSurfaceResult result = ReconstructSurface("landmarks");
  EXPECT_EQ(result.status.code, Status::FAILED_PRECONDITION);
  EXPECT_NE(result.status.message.find("60 points"), std::string::npos) << result.status.message;
  EXPECT_FALSE(Shown().surface);
}

TEST_F(MapFinisherTest, MakesAGridOfAMetricRootMapAlone) {
  MapFinisher(sources_, &shelf_).MakeRootGrid();
  EXPECT_TRUE(Shown().grid);
  MapSnapshot snapshot = *SmallMaps(1);
  now_.snapshot = std::make_shared<const MapSnapshot>(snapshot);
  ++now_.epoch;
  MapFinisher(sources_, &shelf_).MakeRootGrid();
  EXPECT_FALSE(Shown().grid);
}

}  // namespace
}  // namespace rovio_sfm
