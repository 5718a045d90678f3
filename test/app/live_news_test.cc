#include "rovio_sfm/app/live_news.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

using Sentences = std::vector<std::string>;

class LiveNewsTest : public ::testing::Test {
 protected:
  LiveNewsTest() { Show(); }

  // The picture borrows nothing: a copy of what the test has made.
  const MapPicture& Show() {
    picture_.snapshot = std::make_shared<const MapSnapshot>(map_);
    picture_.merges = std::make_shared<const std::vector<MergeReport>>(merges_);
    return picture_;
  }
  void AddSession(uint32_t number, const std::string& robot, size_t num_frames) {
    SessionSnapshot session;
    session.id = SessionId{number};
    session.drive.robot = robot;
    session.state = SessionState::kMapping;
    if (num_frames > 0) {
      session.frames = {std::make_shared<const FrameBlock>(FrameBlock(num_frames))};
    }
    map_.sessions.push_back(session);
  }
  void AddMerge(MergeKind kind, MergeVerdict verdict) {
    MergeReport report;
    report.id = static_cast<uint32_t>(merges_.size()) + 1;
    report.kind = kind;
    report.verdict = verdict;
    report.reason = "as the test says";
    report.other_session = SessionId{1};
    report.query_session = SessionId{2};
    merges_.push_back(report);
  }

  MapSnapshot map_;
  std::vector<MergeReport> merges_;
  MapPicture picture_;
};

TEST_F(LiveNewsTest, TellsThatSessionsBeginAndAreLostOnce) {
  LiveNews news(Show());
  AddSession(1, "rovio1", 0);
  EXPECT_EQ(news.Since(Show()), Sentences{}) << "it looks for its first two frames";
  map_.sessions.clear();
  AddSession(1, "rovio1", 2);
  EXPECT_EQ(news.Since(Show()), Sentences{"session 1 of rovio1 begins"});
  map_.sessions[0].state = SessionState::kLost;
  AddSession(2, "rovio1", 7);
  EXPECT_EQ(news.Since(Show()), (Sentences{"session 1 of rovio1 is lost after 2 frames",
                                           "session 2 of rovio1 begins"}));
  EXPECT_EQ(news.Since(Show()), Sentences{});
}

TEST_F(LiveNewsTest, TellsWhatIsJoinedAndParted) {
  LiveNews news(Show());
  AddMerge(MergeKind::kLoop, MergeVerdict::kAccepted);
  AddMerge(MergeKind::kMerge, MergeVerdict::kRefused);
  AddMerge(MergeKind::kMerge, MergeVerdict::kProvisional);
  EXPECT_EQ(news.Since(Show()), Sentences{"sessions 1 and 2 may be joined: as the test says"});
  merges_[2].verdict = MergeVerdict::kAccepted;
  EXPECT_EQ(news.Since(Show()), Sentences{"sessions 1 and 2 are joined: as the test says"});
  merges_[2].verdict = MergeVerdict::kUndone;
  EXPECT_EQ(news.Since(Show()), Sentences{"sessions 1 and 2 are parted again: as the test says"});
}

TEST_F(LiveNewsTest, MapsOfTheStartAndLoadedOnesAreNone) {
  AddSession(1, "rovio1", 3);
  AddMerge(MergeKind::kMerge, MergeVerdict::kAccepted);
  LiveNews news(Show());
  EXPECT_EQ(news.Since(Show()), Sentences{});
  AddSession(2, "rovio2", 3);
  ++picture_.epoch;
  EXPECT_EQ(news.Since(Show()), Sentences{});
  map_.sessions[1].state = SessionState::kLost;
  EXPECT_EQ(news.Since(Show()), Sentences{"session 2 of rovio2 is lost after 3 frames"});
}

}  // namespace
}  // namespace rovio_sfm
