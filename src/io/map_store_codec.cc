#include "rovio_sfm/io/map_store_codec.h"

#include "rovio_sfm/io/map_store_fields.h"

namespace rovio_sfm {
namespace {

void WriteCounters(const MapperCounters& counters, FieldWriter* writer) {
  for (const uint64_t count :
       {counters.keyframes, counters.light_frames, counters.weak_frames, counters.missing_events,
        counters.refused_events, counters.lost_sessions, counters.global_adjustments}) {
    writer->Write(count);
  }
}

MapperCounters ReadCounters(FieldReader* reader) {
  MapperCounters counters;
  for (uint64_t* count : {&counters.keyframes, &counters.light_frames, &counters.weak_frames,
                          &counters.missing_events, &counters.refused_events,
                          &counters.lost_sessions, &counters.global_adjustments}) {
    *count = reader->Read<uint64_t>("counter");
  }
  return counters;
}

}  // namespace

std::string PoseBytes(const Rigid3& pose) {
  FieldWriter writer;
  WritePose(pose, &writer);
  return writer.Bytes();
}

Rigid3 ReadPose(const Blob& bytes) {
  FieldReader reader = ReaderOf(bytes, "pose");
  const Rigid3 pose = ReadPose(&reader);
  reader.RequireEnd();
  return pose;
}

std::string OdometryBytes(const OdometrySample& sample) {
  FieldWriter writer;
  for (const double value : {sample.x_m, sample.y_m, sample.yaw_rad}) writer.Write(value);
  if (sample.covariance) {
    for (const double value : *sample.covariance) writer.Write(value);
  }
  return writer.Bytes();
}

OdometrySample ReadOdometry(const Blob& bytes) {
  FieldReader reader = ReaderOf(bytes, "odometry");
  OdometrySample sample;
  for (double* value : {&sample.x_m, &sample.y_m, &sample.yaw_rad}) {
    *value = reader.Read<double>("x_m, y_m, yaw_rad");
  }
  if (reader.Left() == 0) return sample;
  sample.covariance.emplace();
  for (double& value : *sample.covariance) value = reader.Read<double>("covariance");
  reader.RequireEnd();
  return sample;
}

std::string TrackBytes(const std::vector<TrackId>& tracks) {
  FieldWriter writer;
  writer.WriteAll(tracks);
  return writer.Bytes();
}

std::vector<TrackId> ReadTracks(const Blob& bytes) {
  FieldReader reader = ReaderOf(bytes, "tracks");
  std::vector<TrackId> tracks = reader.ReadAll<TrackId>("tracks", bytes.size / sizeof(TrackId));
  reader.RequireEnd();
  return tracks;
}

std::string KeypointBytes(const FrameFeatures& features) {
  FieldWriter writer;
  for (size_t i = 0; i < features.keypoints.size(); ++i) {
    const Keypoint& keypoint = features.keypoints[i];
    for (const float value :
         {keypoint.x_px, keypoint.y_px, keypoint.size_px, keypoint.angle_rad, keypoint.response}) {
      writer.Write(value);
    }
    WriteVector<2>(keypoint.x_normalized, &writer);
    const Rgb color = i < features.colors.size() ? features.colors[i] : Rgb{};
    for (const uint8_t value : color) writer.Write(value);
  }
  return writer.Bytes();
}

FrameFeatures ReadKeypoints(const Blob& bytes) {
  FieldReader reader = ReaderOf(bytes, "keypoints");
  FrameFeatures features;
  while (reader.Left() > 0) {
    Keypoint keypoint;
    for (float* value : {&keypoint.x_px, &keypoint.y_px, &keypoint.size_px, &keypoint.angle_rad,
                         &keypoint.response}) {
      *value = reader.Read<float>("keypoint");
    }
    keypoint.x_normalized = ReadVector<2>("x_normalized", &reader);
    Rgb color{};
    for (uint8_t& value : color) value = reader.Read<uint8_t>("color");
    features.keypoints.push_back(keypoint);
    features.colors.push_back(color);
  }
  return features;
}

std::string InlierBytes(const std::vector<FeatureMatch>& inliers) {
  FieldWriter writer;
  WriteMatches(inliers, &writer);
  return writer.Bytes();
}

std::vector<FeatureMatch> ReadInliers(const Blob& bytes) {
  FieldReader reader = ReaderOf(bytes, "inliers");
  std::vector<FeatureMatch> inliers = ReadMatches(&reader);
  reader.RequireEnd();
  return inliers;
}

std::string DriveStateBytes(const DriveState& state) {
  FieldWriter writer;
  writer.Write(static_cast<uint8_t>(state.next_index.has_value()));
  writer.Write(state.next_index.value_or(0));
  for (const auto* indices : {&state.held, &state.unposed}) {
    writer.Write(static_cast<uint32_t>(indices->size()));
    writer.WriteAll(*indices);
  }
  writer.Write(static_cast<uint32_t>(state.weak.size()));
  for (const DriveState::WeakFrame& weak : state.weak) {
    writer.Write(weak.index);
    writer.Write(static_cast<int32_t>(weak.num_tries));
  }
  writer.Write(static_cast<uint32_t>(state.pending_links.size()));
  for (const TrackLink& link : state.pending_links) {
    writer.Write(link.a);
    writer.Write(link.b);
  }
  writer.Write(static_cast<int32_t>(state.num_waited));
  writer.Write(static_cast<int32_t>(state.num_weak_in_row));
  WriteCounters(state.counters, &writer);
  return writer.Bytes();
}

DriveState ReadDriveState(const Blob& bytes) {
  FieldReader reader = ReaderOf(bytes, "state");
  DriveState state;
  const auto has_next = reader.ReadBetween<uint8_t>("has_next_index", 0, 1);
  const auto next = reader.Read<uint32_t>("next_index");
  if (has_next == 1) state.next_index = next;
  if (has_next == 0 && next != 0) reader.Fail("next_index: expected 0 where there is none");
  for (auto* indices : {&state.held, &state.unposed}) {
    *indices = reader.ReadAll<uint32_t>("held, unposed", ReadCount("held, unposed", &reader));
  }
  for (uint32_t left = ReadCount("weak", &reader); left > 0; --left) {
    const auto index = reader.Read<uint32_t>("weak");
    state.weak.push_back({index, reader.Read<int32_t>("num_tries")});
  }
  for (uint32_t left = ReadCount("pending_links", &reader); left > 0; --left) {
    const auto a = reader.Read<TrackId>("link");
    state.pending_links.push_back({a, reader.Read<TrackId>("link")});
  }
  state.num_waited = reader.Read<int32_t>("num_waited");
  state.num_weak_in_row = reader.Read<int32_t>("num_weak_in_row");
  state.counters = ReadCounters(&reader);
  reader.RequireEnd();
  return state;
}

std::string LandmarkBytes(const std::map<TrackId, Landmark>& landmarks, TrackId first,
                          TrackId end) {
  FieldWriter writer;
  for (auto it = landmarks.lower_bound(first); it != landmarks.end() && it->first < end; ++it) {
    const auto& [id, landmark] = *it;
    writer.Write(id);
    WriteVector<3>(landmark.position, &writer);
    for (const uint8_t value : landmark.color) writer.Write(value);
    const EpochStamps& stamps = landmark.stamps;
    for (const uint32_t value : {stamps.born, stamps.moved, stamps.changed}) writer.Write(value);
    writer.Write(static_cast<uint32_t>(landmark.observations.size()));
    for (const Observation& observation : landmark.observations) {
      writer.Write(observation.frame);
      writer.Write(observation.feature);
    }
  }
  return writer.Bytes();
}

void ReadLandmarks(const Blob& bytes, std::map<TrackId, Landmark>* landmarks) {
  FieldReader reader = ReaderOf(bytes, "landmarks");
  TrackId last = 0;
  while (reader.Left() > 0) {
    const auto id = reader.Read<TrackId>("id");
    if (id <= last) reader.Fail("id = " + std::to_string(id) + ": expected ascending ids");
    last = id;
    Landmark landmark;
    landmark.position = ReadVector<3>("position", &reader);
    for (uint8_t& value : landmark.color) value = reader.Read<uint8_t>("color");
    EpochStamps& stamps = landmark.stamps;
    for (uint32_t* value : {&stamps.born, &stamps.moved, &stamps.changed}) {
      *value = reader.Read<uint32_t>("stamps");
    }
    for (uint32_t left = ReadCount("observations", &reader); left > 0; --left) {
      const auto frame = reader.Read<uint32_t>("frame");
      landmark.observations.push_back({frame, reader.Read<uint32_t>("feature")});
    }
    (*landmarks)[id] = std::move(landmark);
  }
}

}  // namespace rovio_sfm
