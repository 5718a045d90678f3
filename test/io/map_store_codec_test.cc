#include "rovio_sfm/io/map_store_codec.h"

#include <gtest/gtest.h>

#include "io/random_records.h"

namespace rovio_sfm {
namespace {

DriveState RandomState(Rng& rng) {
  DriveState state;
  if (rng.UniformInt(2) == 0) state.next_index = rng.UniformInt(1000);
  for (auto* indices : {&state.held, &state.unposed}) {
    indices->resize(rng.UniformInt(5));
    for (uint32_t& index : *indices) index = rng.UniformInt(1000);
  }
  for (uint32_t left = rng.UniformInt(4); left > 0; --left) {
    state.weak.push_back({rng.UniformInt(1000), static_cast<int>(rng.UniformInt(9))});
    state.pending_links.push_back({rng.Next() >> 1, rng.Next() >> 1});
  }
  state.num_waited = static_cast<int>(rng.UniformInt(100));
  state.num_weak_in_row = -1;
  MapperCounters& counters = state.counters;
  for (uint64_t* count : {&counters.keyframes, &counters.light_frames, &counters.weak_frames,
                          &counters.missing_events, &counters.refused_events,
                          &counters.lost_sessions, &counters.global_adjustments}) {
    *count = rng.Next();
  }
  return state;
}

std::map<TrackId, Landmark> RandomLandmarks(Rng& rng) {
  std::map<TrackId, Landmark> landmarks;
  for (uint32_t left = rng.UniformInt(6); left > 0; --left) {
    Landmark& landmark = landmarks[1 + rng.UniformInt(1023)];
    landmark.position = {rng.Gaussian(), rng.Gaussian(), rng.Gaussian()};
    landmark.color = {1, 2, static_cast<uint8_t>(rng.UniformInt(256))};
    landmark.stamps = {rng.UniformInt(5), rng.UniformInt(5), rng.UniformInt(5)};
    landmark.observations.resize(rng.UniformInt(4));
    for (Observation& o : landmark.observations) o = {rng.UniformInt(99), rng.UniformInt(99)};
  }
  return landmarks;
}

TEST(MapStoreCodec, GivesBackPosesAndOdometry) {
  for (uint64_t seed = 1; seed <= 50; ++seed) {
    Rng rng(seed);
    const Rigid3 pose = RandomPose(rng);
    const Rigid3 pose_again = ReadPose(BlobOf(PoseBytes(pose)));
    EXPECT_EQ(pose_again.rotation.coeffs(), pose.rotation.coeffs());
    EXPECT_EQ(pose_again.translation, pose.translation);
    const OdometrySample sample = RandomOdometry(rng);
    const OdometrySample again = ReadOdometry(BlobOf(OdometryBytes(sample)));
    EXPECT_EQ(again.x_m, sample.x_m);
    EXPECT_EQ(again.y_m, sample.y_m);
    EXPECT_EQ(again.yaw_rad, sample.yaw_rad);
    EXPECT_EQ(again.covariance, sample.covariance);
  }
}

TEST(MapStoreCodec, GivesBackKeypoints) {
  Rng rng(1);
  const FrameFeatures features = RandomFeatures(20, true, rng);
  const FrameFeatures again = ReadKeypoints(BlobOf(KeypointBytes(features)));
  ASSERT_EQ(again.keypoints.size(), features.keypoints.size());
  for (size_t i = 0; i < again.keypoints.size(); ++i) {
    const Keypoint &a = again.keypoints[i], &b = features.keypoints[i];
    EXPECT_EQ(a.x_px, b.x_px);
    EXPECT_EQ(a.y_px, b.y_px);
    EXPECT_EQ(a.size_px, b.size_px);
    EXPECT_EQ(a.angle_rad, b.angle_rad);
    EXPECT_EQ(a.response, b.response);
    EXPECT_EQ(a.x_normalized, b.x_normalized);
  }
  EXPECT_EQ(again.colors, features.colors);
  EXPECT_EQ(again.descriptors.length, 0u);  // they have a table of their own
}

TEST(MapStoreCodec, GivesBackTheStateOfADrive) {
  for (uint64_t seed = 1; seed <= 50; ++seed) {
    Rng rng(seed);
    const DriveState state = RandomState(rng);
    const DriveState again = ReadDriveState(BlobOf(DriveStateBytes(state)));
    EXPECT_EQ(again.next_index, state.next_index);
    EXPECT_EQ(again.held, state.held);
    EXPECT_EQ(again.unposed, state.unposed);
    ASSERT_EQ(again.weak.size(), state.weak.size());
    for (size_t i = 0; i < state.weak.size(); ++i) {
      EXPECT_EQ(again.weak[i].index, state.weak[i].index);
      EXPECT_EQ(again.weak[i].num_tries, state.weak[i].num_tries);
      EXPECT_EQ(again.pending_links.at(i).a, state.pending_links[i].a);
      EXPECT_EQ(again.pending_links.at(i).b, state.pending_links[i].b);
    }
    EXPECT_EQ(again.num_waited, state.num_waited);
    EXPECT_EQ(again.num_weak_in_row, state.num_weak_in_row);
    EXPECT_EQ(again.counters.keyframes, state.counters.keyframes);
    EXPECT_EQ(again.counters.global_adjustments, state.counters.global_adjustments);
  }
}

TEST(MapStoreCodec, GivesBackTheLandmarksOfABlock) {
  for (uint64_t seed = 1; seed <= 50; ++seed) {
    Rng rng(seed);
    const std::map<TrackId, Landmark> landmarks = RandomLandmarks(rng);
    std::map<TrackId, Landmark> again;
    ReadLandmarks(BlobOf(LandmarkBytes(landmarks, 0, 512)), &again);
    ReadLandmarks(BlobOf(LandmarkBytes(landmarks, 512, 1024)), &again);
    ASSERT_EQ(again.size(), landmarks.size());
    for (const auto& [id, landmark] : landmarks) {
      EXPECT_EQ(again.at(id).position, landmark.position);
      EXPECT_EQ(again.at(id).color, landmark.color);
      EXPECT_EQ(again.at(id).stamps.born, landmark.stamps.born);
      EXPECT_EQ(again.at(id).stamps.moved, landmark.stamps.moved);
      EXPECT_EQ(again.at(id).stamps.changed, landmark.stamps.changed);
      EXPECT_EQ(again.at(id).observations, landmark.observations);
    }
  }
}

TEST(MapStoreCodec, RefusesSpoiltBytesWithTheColumnNamed) {
  Rng rng(3);
  const auto again = [](auto write, auto read) {
    return [=](const Blob& bytes) { return write(read(bytes)); };
  };
  EXPECT_GT(CountRefused(PoseBytes(RandomPose(rng)), "pose",
                         again(PoseBytes, [](const Blob& bytes) { return ReadPose(bytes); })),
            50u);
  OdometrySample sample = RandomOdometry(rng);
  sample.covariance.emplace();
  EXPECT_GT(CountRefused(OdometryBytes(sample), "odometry", again(OdometryBytes, ReadOdometry)),
            80u);
  EXPECT_GT(CountRefused(TrackBytes({1, 2, 3}), "tracks", again(TrackBytes, ReadTracks)), 20u);
  EXPECT_GT(CountRefused(KeypointBytes(RandomFeatures(3, false, rng)), "keypoints",
                         again(KeypointBytes, ReadKeypoints)),
            100u);
  const std::vector<FeatureMatch> matches(3);
  EXPECT_GT(CountRefused(InlierBytes(matches), "inliers", again(InlierBytes, ReadInliers)), 80u);
  EXPECT_GT(CountRefused(DriveStateBytes(RandomState(rng)), "state",
                         again(DriveStateBytes, ReadDriveState)),
            100u);
  EXPECT_GT(CountRefused(LandmarkBytes(RandomLandmarks(rng), 0, 1024), "landmarks",
                         [](const Blob& bytes) {
                           std::map<TrackId, Landmark> landmarks;
                           ReadLandmarks(bytes, &landmarks);
                           return LandmarkBytes(landmarks, 0, UINT64_MAX);
                         }),
            100u);
}

}  // namespace
}  // namespace rovio_sfm
