#include "rovio_sfm/ros/answer_merge.h"

#include <gtest/gtest.h>
#include <rovio_sfm/Status.h>

#include <limits>

#include "merging/two_drives.h"
#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/map_frames.h"

namespace rovio_sfm {
namespace {

// Two drives that are mapped, each in a map of its own.
class AnswerMerge : public testing::Test {
 protected:
  AnswerMerge() : two_(MakeTwoDrives()), engine_(MapOptions()) {
    for (const FrameEvent& event : two_.a) engine_.Add(event);
    for (const FrameEvent& event : two_.b) engine_.Add(event);
  }

  MergeSessionsResponse Merge(const MergeSessionsRequest& request) {
    return rovio_sfm::AnswerMerge(request, &engine_);
  }
  UnmergeSessionResponse Unmerge(uint32_t session) {
    UnmergeSessionRequest request;
    request.session = session;
    return AnswerUnmerge(request, &engine_);
  }
  bool AreInOneMap() const {
    const auto snapshot = engine_.Picture().snapshot;
    return snapshot->sessions[0].map == snapshot->sessions[1].map;
  }
  static MergeSessionsRequest Request(uint32_t a, uint32_t b) {
    MergeSessionsRequest request;
    request.session_a = a;
    request.session_b = b;
    request.b_from_a.rotation.w = 1.0;
    request.scale = 1.0;
    return request;
  }

  const TwoDrives two_;
  MappingEngine engine_;
};

TEST_F(AnswerMerge, RefusesSessionsThatCannotBeMeant) {
  EXPECT_EQ(Merge(Request(1, 1)).status.code, Status::INVALID_ARGUMENT);
  EXPECT_EQ(Merge(Request(1, 9)).status.code, Status::NOT_FOUND);
  EXPECT_EQ(Unmerge(9).status.code, Status::NOT_FOUND);
}

TEST_F(AnswerMerge, SaysThatNoOverlapIsKnown) {
  const MergeSessionsResponse response = Merge(Request(1, 2));
  EXPECT_EQ(response.status.code, Status::FAILED_PRECONDITION);
  EXPECT_EQ(response.report.verdict, MergeReportMsg::REFUSED);
  EXPECT_NE(response.status.message.find("no overlap"), std::string::npos);
}

TEST_F(AnswerMerge, UndoesAMergeAndMakesItAgain) {
  engine_.Add(TrueOverlap(two_, 8, 8));
  ASSERT_TRUE(AreInOneMap()) << engine_.Picture().merges->at(0).reason;
  const UnmergeSessionResponse undone = Unmerge(2);
  EXPECT_EQ(undone.status.code, Status::OK);
  ASSERT_EQ(undone.undone.size(), 1u);
  EXPECT_EQ(undone.undone[0].verdict, MergeReportMsg::UNDONE);
  EXPECT_FALSE(AreInOneMap());
  EXPECT_EQ(Unmerge(2).status.code, Status::FAILED_PRECONDITION);
  const MergeSessionsResponse again = Merge(Request(1, 2));
  EXPECT_EQ(again.status.code, Status::OK) << again.status.message;
  EXPECT_TRUE(AreInOneMap());
  EXPECT_EQ(Merge(Request(1, 2)).status.code, Status::FAILED_PRECONDITION);
}

TEST_F(AnswerMerge, PlacesByHandWhatTfThenSays) {
  MergeSessionsRequest request = Request(1, 2);
  request.by_hand = true;
  request.b_from_a.translation.x = -3.0;
  const MergeSessionsResponse response = Merge(request);
  ASSERT_EQ(response.status.code, Status::OK) << response.status.message;
  for (const auto& edge : MapEdges(engine_.Picture(), ros::Time(5))) {
    if (edge.child_frame_id != "session_2/map") continue;
    EXPECT_EQ(edge.header.frame_id, "map");
    EXPECT_NEAR(edge.transform.translation.x, 3.0, 1e-9);
    EXPECT_NEAR(edge.transform.rotation.w, 1.0, 1e-9);
    return;
  }
  FAIL() << "no edge to session_2/map";
}

TEST_F(AnswerMerge, RefusesAMalformedPlacement) {
  MergeSessionsRequest request = Request(1, 2);
  request.by_hand = true;
  request.scale = 0.0;
  EXPECT_EQ(Merge(request).status.code, Status::INVALID_ARGUMENT);
  EXPECT_EQ(Merge(request).status.message, "scale = 0: expected 0.001 to 1000");
  request.scale = 1.0;
  request.b_from_a.rotation.w = 0.0;
  const MergeSessionsResponse response = Merge(request);
  EXPECT_EQ(response.status.code, Status::INVALID_ARGUMENT);
  EXPECT_EQ(response.status.message,
            "b_from_a.rotation = [0, 0, 0, 0]: expected a quaternion of norm 1");
  request.b_from_a.translation.y = std::numeric_limits<double>::infinity();
  EXPECT_EQ(Merge(request).status.message,
            "b_from_a.translation.y = inf: expected a finite number");
  EXPECT_FALSE(AreInOneMap());
}

}  // namespace
}  // namespace rovio_sfm
