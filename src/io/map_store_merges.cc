#include "rovio_sfm/io/map_store_merges.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "rovio_sfm/io/map_store_merge_codec.h"

namespace rovio_sfm {
namespace {

uint32_t ReadNumber(const std::string& text) {
  uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size()) return number;
  throw StoreError("info: num_accepted = " + text + ": expected a number");
}

}  // namespace

StoredMerges::Face StoredMerges::FaceOf(const MergeEdit& edit) {
  return {edit.report, edit.sequence, edit.marks, edit.links};
}

bool StoredMerges::IsSame(const Face& face, const MergeEdit& edit) {
  return face.report == edit.report && face.sequence == edit.sequence && face.marks == edit.marks &&
         face.links == edit.links;
}

int64_t StoredMerges::RowOf(const DriveId& drive) const {
  return frames_->FindRow(drive).value_or(0);
}

// Place matches may come before their drives: those have no row yet.
bool StoredMerges::AreDrivesKnown(const PlaceMatch& match) const {
  return RowOf(match.query.drive) != 0 &&
         std::all_of(match.pairs.begin(), match.pairs.end(),
                     [this](const OverlapPair& pair) { return RowOf(pair.other.drive) != 0; });
}

void StoredMerges::PutEdits(const std::deque<MergeEdit>& edits) {
  for (size_t i = 0; i < edits.size(); ++i) {
    const bool is_kept = i < kept_edits_.size();
    if (is_kept && IsSame(kept_edits_[i], edits[i])) continue;
    PutEdit(edits[i]);
    if (!is_kept) kept_edits_.push_back(FaceOf(edits[i]));
    kept_edits_[i] = FaceOf(edits[i]);
  }
}

void StoredMerges::PutEdit(const MergeEdit& edit) {
  const DriveRowOf row_of = [this](const DriveId& drive) { return RowOf(drive); };
  const std::string report = ReportBytes(edit.report, row_of);
  const std::string match = MatchBytes(edit.match, row_of);
  const std::string links = LinkBytes(edit.links.List()), marks = MarkBytes(edit.marks);
  database_->Run(
      "INSERT OR REPLACE INTO merge_edit (id, query_session, other_session, kind, verdict, reason, "
      "accepted_by, sequence, report, place_match, links, marks) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
      edit.report.id, edit.report.query_session.value, edit.report.other_session.value,
      std::string(ToString(edit.report.kind)), std::string(ToString(edit.report.verdict)),
      edit.report.reason, static_cast<int>(edit.report.accepted_by), edit.sequence, BlobOf(report),
      BlobOf(match), BlobOf(links), BlobOf(marks));
}

void StoredMerges::PutGauges(uint32_t num_accepted, const std::map<MapId, uint32_t>& revisions,
                             const std::set<std::pair<SessionId, SessionId>>& separated) {
  if (num_accepted != kept_accepted_) {
    database_->Run("INSERT OR REPLACE INTO info (name, value) VALUES ('num_accepted', ?)",
                   std::to_string(num_accepted));
    kept_accepted_ = num_accepted;
  }
  if (revisions != kept_revisions_) {
    for (const auto& [map, revision] : revisions) {
      database_->Run("INSERT OR REPLACE INTO gauge (map, revision) VALUES (?, ?)", map.value,
                     revision);
    }
    kept_revisions_ = revisions;
  }
  if (separated == kept_separated_) return;
  database_->Run("DELETE FROM separated");
  for (const auto& [a, b] : separated) {
    database_->Run("INSERT INTO separated (a, b) VALUES (?, ?)", a.value, b.value);
  }
  kept_separated_ = separated;
}

void StoredMerges::PutWaiting(const std::vector<PlaceMatch>& waiting) {
  std::vector<WaitingKey> keys;
  for (const PlaceMatch& match : waiting) {
    if (!AreDrivesKnown(match)) continue;
    keys.emplace_back(match.query, match.pairs.front().other);
  }
  if (keys == kept_waiting_) return;
  database_->Run("DELETE FROM waiting_match");
  const DriveRowOf row_of = [this](const DriveId& drive) { return RowOf(drive); };
  int position = 0;
  for (const PlaceMatch& match : waiting) {
    if (!AreDrivesKnown(match)) continue;
    const std::string bytes = MatchBytes(match, row_of);
    database_->Run("INSERT INTO waiting_match (position, place_match) VALUES (?, ?)", ++position,
                   BlobOf(bytes));
  }
  kept_waiting_ = std::move(keys);
}

MergeRecord StoredMerges::Read() {
  MergeRecord record;
  record.edits = ReadEdits();
  record.waiting = ReadWaiting();
  {
    Rows rows = database_->Query("SELECT value FROM info WHERE name = 'num_accepted'");
    if (rows.Next()) record.num_accepted = ReadNumber(rows.Text(0));
  }
  Rows gauges = database_->Query("SELECT map, revision FROM gauge");
  while (gauges.Next()) {
    record.revisions[{static_cast<uint32_t>(gauges.Int(0))}] = static_cast<uint32_t>(gauges.Int(1));
  }
  Rows separated = database_->Query("SELECT a, b FROM separated");
  while (separated.Next()) {
    record.separated.insert({SessionId{static_cast<uint32_t>(separated.Int(0))},
                             SessionId{static_cast<uint32_t>(separated.Int(1))}});
  }
  kept_edits_.clear();
  kept_waiting_.clear();
  for (const MergeEdit& edit : record.edits) kept_edits_.push_back(FaceOf(edit));
  for (const PlaceMatch& match : record.waiting) {
    kept_waiting_.emplace_back(match.query, match.pairs.front().other);
  }
  kept_accepted_ = record.num_accepted;
  kept_revisions_ = record.revisions;
  kept_separated_ = record.separated;
  return record;
}

std::vector<MergeEdit> StoredMerges::ReadEdits() const {
  std::vector<MergeEdit> edits;
  const DriveAt drive_at = [this](int64_t row) { return frames_->DriveAt(row); };
  Rows rows = database_->Query(
      "SELECT id, accepted_by, sequence, report, place_match, links, marks FROM merge_edit "
      "ORDER BY id");
  while (rows.Next()) {
    MergeEdit edit;
    edit.report = ReadReport(rows.Bytes(3), drive_at);
    edit.report.id = static_cast<uint32_t>(rows.Int(0));
    edit.report.accepted_by = ReadEnum(rows, 1, AcceptedBy::kHand, "merge_edit.accepted_by");
    edit.sequence = static_cast<uint32_t>(rows.Int(2));
    edit.match = ReadMatch(rows.Bytes(4), drive_at);
    edit.links = ReadLinks(rows.Bytes(5));
    edit.marks = ReadMarks(rows.Bytes(6));
    if (edit.report.id != edits.size() + 1) {
      throw StoreError(database_->file() + ": merge_edit: id = " + std::to_string(edit.report.id) +
                       ": expected " + std::to_string(edits.size() + 1));
    }
    edits.push_back(std::move(edit));
  }
  return edits;
}

std::vector<PlaceMatch> StoredMerges::ReadWaiting() const {
  std::vector<PlaceMatch> waiting;
  const DriveAt drive_at = [this](int64_t row) { return frames_->DriveAt(row); };
  Rows rows = database_->Query("SELECT place_match FROM waiting_match ORDER BY position");
  while (rows.Next()) {
    waiting.push_back(ReadMatch(rows.Bytes(0), drive_at));
    if (!waiting.back().pairs.empty()) continue;
    throw StoreError(database_->file() + ": waiting_match: expected a pair at least");
  }
  return waiting;
}

}  // namespace rovio_sfm
