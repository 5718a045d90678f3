#include "rovio_sfm/io/map_store_merges.h"

#include <gtest/gtest.h>

#include <functional>

#include "io/random_records.h"
#include "rovio_sfm/io/map_store_merge_codec.h"
#include "rovio_sfm/io/map_store_schema.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

const FrameId kQuery{{"second", 2, 7}, 5};
const FrameId kOther{{"first", 1, 0}, 9};

std::string AllOf(const MergeEdit& edit) {
  const DriveRowOf row_of = [](const DriveId& drive) { return drive == kQuery.drive ? 2 : 1; };
  return std::to_string(edit.report.id) + " " + ReportBytes(edit.report, row_of) +
         MatchBytes(edit.match, row_of) + LinkBytes(edit.links.List()) + MarkBytes(edit.marks) +
         std::to_string(int(edit.report.accepted_by)) + " " + std::to_string(edit.sequence);
}

MergeEdit RandomEdit(uint32_t id, Rng& rng) {
  MergeEdit edit;
  edit.report = RandomReport(kQuery, kOther, rng);
  edit.report.id = id;
  edit.match = RandomMatch(kQuery, kOther, rng);
  edit.links = RandomLinks(rng);
  edit.report.accepted_by = static_cast<AcceptedBy>(rng.UniformInt(5));
  edit.sequence = rng.UniformInt(9);
  edit.marks = {{{1}, rng.UniformInt(9)}};
  return edit;
}

class MapStoreMerges : public ::testing::Test {
 protected:
  MapStoreMerges() {
    frames_.RowOf(kOther.drive, MakeSyntheticCamera());
    frames_.RowOf(kQuery.drive, MakeSyntheticCamera());
    for (const int id : {1, 2, 3}) {
      database_.Run("INSERT INTO session (id, drive, state, num_marks) VALUES (?, 1, 0, 0)", id);
    }
  }
  MergeRecord ReadAnew() { return StoredMerges(&database_, &frames_).Read(); }
  void ExpectKept(const std::deque<MergeEdit>& edits, const std::string& what) {
    merges_.PutEdits(edits);
    const MergeRecord record = ReadAnew();
    ASSERT_EQ(record.edits.size(), edits.size());
    for (size_t i = 0; i < edits.size(); ++i) {
      EXPECT_EQ(AllOf(record.edits[i]), AllOf(edits[i])) << what << ", edit " << i;
    }
  }

  const TemporaryFolder folder_;
  StoreDatabase database_{folder_.Path() / "map.db", StoreAccess::kCreate};
  struct Opened {
    explicit Opened(StoreDatabase* database) { OpenSchema(StoreAccess::kCreate, database); }
  } opened_{&database_};
  StoredFrames frames_{&database_};
  StoredMerges merges_{&database_, &frames_};
};

// Each field of an edit that mapping may change, by itself.
TEST_F(MapStoreMerges, KeepEveryChangeOfAnEdit) {
  Rng rng(1);
  std::deque<MergeEdit> edits;
  for (uint32_t id = 1; id <= 3; ++id) {
    edits.push_back(RandomEdit(id, rng));
    ExpectKept(edits, "new");
  }
  MergeEdit& edit = edits[1];
  edit.links = std::vector<FeatureLink>{{{{1}, 2, 3}, {{2}, 5, 6}}};
  ExpectKept(edits, "links");
  const std::vector<std::pair<const char*, std::function<void()>>> changes = {
      {"verdict", [&] { edit.report.verdict = MergeVerdict::kUndone; }},
      {"kind", [&] { edit.report.kind = MergeKind::kLoop; }},
      {"reason", [&] { edit.report.reason = "another"; }},
      {"warning", [&] { edit.report.warning = "careful"; }},
      {"num_inliers", [&] { ++edit.report.num_inliers; }},
      {"query_from_other", [&] { edit.report.query_from_other.scale = 3.0; }},
      {"error_before_px", [&] { edit.report.error_before_px = 4.0; }},
      {"error_after_px", [&] { edit.report.error_after_px = 5.0; }},
      {"no error_after_px", [&] { edit.report.error_after_px.reset(); }},
      {"accepted_by", [&] { edit.report.accepted_by = AcceptedBy::kHand; }},
      {"sequence", [&] { edit.sequence = 77; }},
      {"a mark",
       [&] {
         edit.marks = {{{1}, 55}};
       }},
      {"another mark", [&] { edit.marks[{2}] = 3; }},
      {"no marks", [&] { edit.marks.clear(); }},
      {"a link", [&] {
         edit.links = std::vector<FeatureLink>{{{{1}, 2, 9}, {{2}, 5, 6}}};
       }}};
  for (const auto& [what, change] : changes) {
    change();
    ExpectKept(edits, what);
  }
}

TEST_F(MapStoreMerges, WriteOnlyWhatChanged) {
  Rng rng(1);
  const std::deque<MergeEdit> edits = {RandomEdit(1, rng), RandomEdit(2, rng)};
  merges_.PutEdits(edits);
  database_.Execute("DELETE FROM merge_edit");
  merges_.PutEdits(edits);
  EXPECT_TRUE(ReadAnew().edits.empty());
}

TEST_F(MapStoreMerges, KeepGaugesAndWhatWasSeparated) {
  const std::map<MapId, uint32_t> revisions = {{{1}, 3}, {{2}, 1}};
  const std::set<std::pair<SessionId, SessionId>> separated = {{{1}, {2}}, {{1}, {3}}};
  merges_.PutGauges(4, revisions, separated);
  EXPECT_EQ(ReadAnew().num_accepted, 4u);
  EXPECT_EQ(ReadAnew().revisions, revisions);
  EXPECT_EQ(ReadAnew().separated, separated);
  merges_.PutGauges(5, {{{1}, 4}, {{2}, 1}}, {});
  EXPECT_EQ(ReadAnew().num_accepted, 5u);
  EXPECT_EQ(ReadAnew().revisions.at({1}), 4u);
  EXPECT_TRUE(ReadAnew().separated.empty());
}

TEST_F(MapStoreMerges, KeepMatchesThatWaitInTheirOrder) {
  Rng rng(1);
  std::vector<PlaceMatch> waiting;
  for (uint32_t i = 0; i < 5; ++i) {
    waiting.push_back(RandomMatch({kQuery.drive, 9 - i}, kOther, rng));
  }
  merges_.PutWaiting(waiting);
  waiting.erase(waiting.begin() + 1);
  merges_.PutWaiting(waiting);
  const std::vector<PlaceMatch> again = ReadAnew().waiting;
  ASSERT_EQ(again.size(), 4u);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(again[i].query, waiting[i].query);
    EXPECT_EQ(again[i].pairs.size(), waiting[i].pairs.size());
  }
  merges_.PutWaiting({});
  EXPECT_TRUE(ReadAnew().waiting.empty());
}

// Their frames would have no drive to be of. They are kept as soon as it is known.
TEST_F(MapStoreMerges, KeepAMatchOnceAllItsDrivesAreKnown) {
  Rng rng(1);
  const DriveId later{"third", 3, 0};
  PlaceMatch match = RandomMatch(kQuery, kOther, rng);
  match.pairs.push_back(match.pairs[0]);
  match.pairs.back().other.drive = later;
  merges_.PutWaiting({match});
  EXPECT_TRUE(ReadAnew().waiting.empty());
  frames_.RowOf(later, MakeSyntheticCamera());
  merges_.PutWaiting({match});
  ASSERT_EQ(ReadAnew().waiting.size(), 1u);
  EXPECT_EQ(ReadAnew().waiting[0].pairs.back().other.drive, later);
}

TEST_F(MapStoreMerges, RefuseTablesThatContradictThemselves) {
  Rng rng(1);
  const auto error_after = [&](const std::string& change) {
    database_.Execute("DELETE FROM merge_edit; DELETE FROM waiting_match; DELETE FROM info");
    StoredMerges merges(&database_, &frames_);
    merges.PutEdits({RandomEdit(1, rng), RandomEdit(2, rng)});
    merges.PutWaiting({RandomMatch(kQuery, kOther, rng)});
    merges.PutGauges(3, {}, {});
    database_.Execute(change);
    return MessageOf([&] { ReadAnew(); });
  };
  for (const auto& [change, expected] : std::initializer_list<std::pair<const char*, const char*>>{
           {"DELETE FROM merge_edit WHERE id = 1", "merge_edit: id = 2: expected 1"},
           {"UPDATE merge_edit SET accepted_by = 9", "merge_edit.accepted_by = 9: expected 0 to 4"},
           {"UPDATE merge_edit SET report = x'00'", "report: cut short"},
           {"UPDATE waiting_match SET place_match = x'00'", "match: cut short"},
           {"UPDATE info SET value = '5 or so'", "info: num_accepted = 5 or so"}}) {
    const std::string error = error_after(change);
    EXPECT_NE(error.find(expected), std::string::npos) << change << ": " << error;
  }
}

}  // namespace
}  // namespace rovio_sfm
