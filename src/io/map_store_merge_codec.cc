#include "rovio_sfm/io/map_store_merge_codec.h"

namespace rovio_sfm {
namespace {

constexpr uint32_t kMaxText = 1u << 20;

void WriteFeatureRef(const FeatureRef& feature, FieldWriter* writer) {
  writer->Write(feature.session.value);
  writer->Write(feature.frame);
  writer->Write(feature.feature);
}

FeatureRef ReadFeatureRef(FieldReader* reader) {
  FeatureRef feature;
  feature.session.value = reader->Read<uint32_t>("session");
  feature.frame = reader->Read<uint32_t>("frame");
  feature.feature = reader->Read<uint32_t>("feature");
  return feature;
}

}  // namespace

std::string LinkBytes(const std::vector<FeatureLink>& links) {
  FieldWriter writer;
  for (const FeatureLink& link : links) {
    WriteFeatureRef(link.a, &writer);
    WriteFeatureRef(link.b, &writer);
  }
  return writer.Bytes();
}

std::vector<FeatureLink> ReadLinks(const Blob& bytes) {
  FieldReader reader = ReaderOf(bytes, "links");
  std::vector<FeatureLink> links;
  while (reader.Left() > 0) {
    const FeatureRef a = ReadFeatureRef(&reader);
    links.push_back({a, ReadFeatureRef(&reader)});
  }
  return links;
}

std::string MarkBytes(const std::map<SessionId, uint32_t>& marks) {
  FieldWriter writer;
  for (const auto& [session, mark] : marks) {
    writer.Write(session.value);
    writer.Write(mark);
  }
  return writer.Bytes();
}

std::map<SessionId, uint32_t> ReadMarks(const Blob& bytes) {
  FieldReader reader = ReaderOf(bytes, "marks");
  std::map<SessionId, uint32_t> marks;
  while (reader.Left() > 0) {
    const auto session = reader.Read<uint32_t>("session");
    if (!marks.empty() && session <= marks.rbegin()->first.value) {
      reader.Fail("session = " + std::to_string(session) + ": expected ascending ids");
    }
    marks[SessionId{session}] = reader.Read<uint32_t>("mark");
  }
  return marks;
}

std::string MatchBytes(const PlaceMatch& match, const DriveRowOf& row_of) {
  FieldWriter writer;
  WriteFrameId(match.query, row_of, &writer);
  writer.Write(match.probability);
  writer.Write(match.score);
  writer.Write(static_cast<uint32_t>(match.pairs.size()));
  for (const OverlapPair& pair : match.pairs) {
    WriteFrameId(pair.other, row_of, &writer);
    writer.Write(static_cast<uint8_t>(pair.verdict));
    WritePose(pair.query_from_other, &writer);
    WriteMatches(pair.inliers, &writer);
  }
  return writer.Bytes();
}

PlaceMatch ReadMatch(const Blob& bytes, const DriveAt& drive_at) {
  FieldReader reader = ReaderOf(bytes, "match");
  PlaceMatch match;
  match.query = ReadFrameId(drive_at, &reader);
  match.probability = reader.Read<double>("probability");
  match.score = reader.Read<double>("score");
  for (uint32_t left = ReadCount("pairs", &reader); left > 0; --left) {
    OverlapPair pair;
    pair.other = ReadFrameId(drive_at, &reader);
    pair.verdict = static_cast<PairVerdict>(reader.ReadBetween<uint8_t>("verdict", 0, 3));
    pair.query_from_other = ReadPose(&reader);
    pair.inliers = ReadMatches(&reader);
    match.pairs.push_back(std::move(pair));
  }
  reader.RequireEnd();
  return match;
}

std::string ReportBytes(const MergeReport& report, const DriveRowOf& row_of) {
  FieldWriter writer;
  writer.Write(static_cast<uint8_t>(report.kind));
  writer.Write(static_cast<uint8_t>(report.verdict));
  writer.WriteText(report.reason);
  writer.WriteText(report.warning);
  WriteFrameId(report.query, row_of, &writer);
  WriteFrameId(report.other, row_of, &writer);
  writer.Write(report.query_session.value);
  writer.Write(report.other_session.value);
  for (const uint32_t count :
       {report.num_candidates, report.num_matches, report.num_inliers, report.num_common,
        report.num_expected, report.num_found, report.num_links}) {
    writer.Write(count);
  }
  writer.Write(static_cast<uint8_t>(report.by_resection));
  writer.Write(report.query_from_other.scale);
  WritePose({report.query_from_other.rotation, report.query_from_other.translation}, &writer);
  writer.Write(report.sigma_log_scale);
  writer.Write(report.error_before_px);
  if (report.error_after_px) writer.Write(*report.error_after_px);
  return writer.Bytes();
}

MergeReport ReadReport(const Blob& bytes, const DriveAt& drive_at) {
  FieldReader reader = ReaderOf(bytes, "report");
  MergeReport report;
  report.kind = static_cast<MergeKind>(reader.ReadBetween<uint8_t>("kind", 0, 2));
  report.verdict = static_cast<MergeVerdict>(reader.ReadBetween<uint8_t>("verdict", 0, 4));
  report.reason = reader.ReadText("reason", kMaxText);
  report.warning = reader.ReadText("warning", kMaxText);
  report.query = ReadFrameId(drive_at, &reader);
  report.other = ReadFrameId(drive_at, &reader);
  report.query_session.value = reader.Read<uint32_t>("query_session");
  report.other_session.value = reader.Read<uint32_t>("other_session");
  for (uint32_t* count :
       {&report.num_candidates, &report.num_matches, &report.num_inliers, &report.num_common,
        &report.num_expected, &report.num_found, &report.num_links}) {
    *count = reader.Read<uint32_t>("count");
  }
  report.by_resection = reader.ReadBetween<uint8_t>("by_resection", 0, 1) == 1;
  report.query_from_other.scale = reader.ReadBetween<double>("scale", 1e-9, 1e9);
  const Rigid3 pose = ReadPose(&reader);
  report.query_from_other.rotation = pose.rotation;
  report.query_from_other.translation = pose.translation;
  report.sigma_log_scale = reader.Read<double>("sigma_log_scale");
  report.error_before_px = reader.Read<double>("error_before_px");
  if (reader.Left() > 0) report.error_after_px = reader.Read<double>("error_after_px");
  reader.RequireEnd();
  return report;
}

}  // namespace rovio_sfm
