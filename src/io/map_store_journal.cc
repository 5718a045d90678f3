#include "rovio_sfm/io/map_store_journal.h"

#include <memory>
#include <utility>
#include <vector>

#include "rovio_sfm/io/map_store_codec.h"
#include "rovio_sfm/io/map_store_fields.h"

namespace rovio_sfm {
namespace {

// Each list: how many entries follow, then each.
template <typename Entry, typename WriteEntry>
void WriteList(const std::vector<Entry>& list, size_t from, FieldWriter* writer,
               const WriteEntry& write) {
  writer->Write(static_cast<uint32_t>(list.size() - from));
  for (size_t i = from; i < list.size(); ++i) write(list[i]);
}

template <typename ReadEntry>
void ReadList(const char* field, FieldReader* reader, const ReadEntry& read) {
  for (uint32_t left = ReadCount(field, reader); left > 0; --left) read();
}

void WriteBytes(const std::string& bytes, FieldWriter* writer) { writer->WriteText(bytes); }

// The bytes of another column, here as a field.
template <typename ReadColumn>
auto ReadBytes(const char* field, FieldReader* reader, const ReadColumn& read) {
  const std::string bytes = reader->ReadText(field, kMaxCount);
  try {
    return read(BlobOf(bytes));
  } catch (const std::runtime_error& error) {
    reader->Fail(error.what());
  }
}

void WriteStamps(const EpochStamps& stamps, FieldWriter* writer) {
  for (const uint32_t stamp : {stamps.born, stamps.moved, stamps.changed}) writer->Write(stamp);
}

EpochStamps ReadStamps(FieldReader* reader) {
  EpochStamps stamps;
  for (uint32_t* stamp : {&stamps.born, &stamps.moved, &stamps.changed}) {
    *stamp = reader->Read<uint32_t>("stamps");
  }
  return stamps;
}

void WriteKeyframe(const Keyframe& frame, FieldWriter* writer) {
  writer->Write(static_cast<uint8_t>(frame.weak));
  WritePose(frame.cam_from_session, writer);
  WriteStamps(frame.stamps, writer);
  WriteBytes(TrackBytes(frame.tracks), writer);
}

Keyframe ReadKeyframe(Keyframe frame, FieldReader* reader) {
  frame.weak = reader->ReadBetween<uint8_t>("weak", 0, 1) == 1;
  frame.cam_from_session = ReadPose(reader);
  frame.stamps = ReadStamps(reader);
  frame.tracks = ReadBytes("tracks", reader, ReadTracks);
  if (frame.tracks.size() != frame.points.size()) {
    reader->Fail("tracks: " + std::to_string(frame.tracks.size()) + " values, expected " +
                 std::to_string(frame.points.size()));
  }
  return frame;
}

void WriteLightFrame(const LightFrame& frame, FieldWriter* writer) {
  writer->Write(frame.reference);
  writer->Write(frame.num_inliers);
  WritePose(frame.cam_from_reference, writer);
  WriteStamps(frame.stamps, writer);
}

LightFrame ReadLightFrame(LightFrame frame, FieldReader* reader) {
  frame.reference = reader->Read<uint32_t>("reference");
  frame.num_inliers = reader->Read<uint32_t>("num_inliers");
  frame.cam_from_reference = ReadPose(reader);
  frame.stamps = ReadStamps(reader);
  return frame;
}

void WriteLandmark(TrackId id, const Landmark& landmark, FieldWriter* writer) {
  WriteBytes(LandmarkBytes({{id, landmark}}, id, id + 1), writer);
}

std::pair<TrackId, std::shared_ptr<const Landmark>> ReadLandmark(FieldReader* reader) {
  std::map<TrackId, Landmark> one;
  ReadBytes("landmark", reader, [&](const Blob& bytes) { ReadLandmarks(bytes, &one); });
  if (one.size() != 1) reader->Fail("landmark: expected one");
  return {one.begin()->first, std::make_shared<const Landmark>(one.begin()->second)};
}

void ReadSmallLists(FieldReader* reader, SessionEpoch* epoch) {
  ReadList("poses", reader, [&] {
    SessionEpoch::PoseBefore pose;
    pose.frame = reader->Read<uint32_t>("frame");
    pose.weak = reader->ReadBetween<uint8_t>("weak", 0, 1) == 1;
    pose.cam_from_session = ReadPose(reader);
    epoch->poses.push_back(pose);
  });
  ReadList("light_poses", reader, [&] {
    SessionEpoch::LightPoseBefore pose;
    pose.frame = reader->Read<uint32_t>("frame");
    pose.reference = reader->Read<uint32_t>("reference");
    pose.num_inliers = reader->Read<uint32_t>("num_inliers");
    pose.cam_from_reference = ReadPose(reader);
    epoch->light_poses.push_back(pose);
  });
  ReadList("members", reader, [&] {
    SessionEpoch::MemberBefore member;
    member.frame = reader->Read<uint32_t>("frame");
    member.feature = reader->Read<uint32_t>("feature");
    member.track = reader->Read<TrackId>("track");
    epoch->members.push_back(member);
  });
  ReadList("positions", reader, [&] {
    const auto track = reader->Read<TrackId>("track");
    epoch->positions.Add(track, ReadVector<3>("position", reader));
  });
  ReadList("aliases", reader, [&] { epoch->aliases.push_back(reader->Read<TrackId>("alias")); });
}

}  // namespace

EpochSizes SizesOf(const SessionEpoch& epoch) {
  return {epoch.poses.size(),     epoch.light_poses.size(), epoch.members.size(),
          epoch.positions.size(), epoch.aliases.size(),     epoch.landmarks.size(),
          epoch.keyframes.size(), epoch.light_frames.size()};
}

std::string EpochBytes(const SessionEpoch& epoch, const EpochSizes& from) {
  FieldWriter writer;
  WriteList(epoch.poses, from[0], &writer, [&](const SessionEpoch::PoseBefore& pose) {
    writer.Write(pose.frame);
    writer.Write(static_cast<uint8_t>(pose.weak));
    WritePose(pose.cam_from_session, &writer);
  });
  WriteList(epoch.light_poses, from[1], &writer, [&](const SessionEpoch::LightPoseBefore& pose) {
    for (const uint32_t value : {pose.frame, pose.reference, pose.num_inliers}) writer.Write(value);
    WritePose(pose.cam_from_reference, &writer);
  });
  WriteList(epoch.members, from[2], &writer, [&](const SessionEpoch::MemberBefore& member) {
    writer.Write(member.frame);
    writer.Write(member.feature);
    writer.Write(member.track);
  });
  WriteList(epoch.positions.List(), from[3], &writer, [&](const auto& position) {
    writer.Write(position.first);
    WriteVector<3>(position.second, &writer);
  });
  WriteList(epoch.aliases, from[4], &writer, [&](TrackId alias) { writer.Write(alias); });
  WriteList(epoch.landmarks, from[5], &writer, [&](const auto& landmark) {
    WriteLandmark(landmark.first, *landmark.second, &writer);
  });
  WriteList(epoch.keyframes, from[6], &writer, [&](const auto& frame) {
    writer.Write(frame.first);
    WriteKeyframe(*frame.second, &writer);
  });
  WriteList(epoch.light_frames, from[7], &writer, [&](const auto& frame) {
    writer.Write(frame.first);
    WriteLightFrame(*frame.second, &writer);
  });
  return writer.Bytes();
}

void ReadEpoch(const Blob& bytes, const FrameMaker& make, const EventOf& event_of,
               SessionEpoch* epoch) {
  FieldReader reader = ReaderOf(bytes, "journal");
  ReadSmallLists(&reader, epoch);
  ReadList("landmarks", &reader, [&] { epoch->landmarks.push_back(ReadLandmark(&reader)); });
  ReadList("keyframes", &reader, [&] {
    const auto index = reader.Read<uint32_t>("frame");
    epoch->keyframes.emplace_back(index, std::make_shared<const Keyframe>(ReadKeyframe(
                                             make.keyframe(event_of(index)), &reader)));
  });
  ReadList("light_frames", &reader, [&] {
    const auto index = reader.Read<uint32_t>("frame");
    epoch->light_frames.emplace_back(index, std::make_shared<const LightFrame>(ReadLightFrame(
                                                make.light_frame(event_of(index)), &reader)));
  });
  reader.RequireEnd();
}

}  // namespace rovio_sfm
