#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "rovio_sfm/io/map_store_database.h"
#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/scene/merge_edit.h"
#include "rovio_sfm/util/rng.h"
#include "synthetic/synthetic_session.h"
#include "synthetic/synthetic_world.h"

namespace rovio_sfm {

// Records with something in every field, for what must come back from a store as it went in.

inline Rigid3 RandomPose(Rng& rng) { return PerturbPose({}, 0.5, 2.0, rng); }

inline std::vector<FeatureMatch> RandomMatches(uint32_t num_features, Rng& rng) {
  std::vector<FeatureMatch> matches(num_features == 0 ? 0 : rng.UniformInt(8));
  for (FeatureMatch& match : matches) {
    match.a = rng.UniformInt(1000);
    match.b = rng.UniformInt(num_features);
    match.distance = static_cast<float>(rng.Uniform());
    match.ratio = static_cast<float>(rng.Uniform());
  }
  return matches;
}

inline FrameFeatures RandomFeatures(uint32_t count, bool with_descriptors, Rng& rng) {
  FrameFeatures features;
  const auto any = [&] { return static_cast<float>(rng.Uniform(-1.0, 400.0)); };
  const auto byte = [&] { return static_cast<uint8_t>(rng.UniformInt(256)); };
  for (uint32_t i = 0; i < count; ++i) {
    features.keypoints.push_back(
        {any(), any(), any(), any(), any(), {rng.Gaussian(), rng.Gaussian()}});
    features.colors.push_back({byte(), byte(), byte()});
  }
  if (!with_descriptors) return features;
  features.descriptors.type = DescriptorType::kAkaze;
  features.descriptors.metric = DescriptorMetric::kHamming;
  features.descriptors.length = 8 + rng.UniformInt(56);
  features.descriptors.data.resize(count * features.descriptors.length);
  for (uint8_t& value : features.descriptors.data) value = byte();
  return features;
}

inline PairMatches RandomPair(uint32_t num_features, Rng& rng) {
  PairMatches pair;
  pair.other_index = rng.UniformInt(1000);
  pair.counts = {rng.UniformInt(9), rng.UniformInt(9), rng.UniformInt(9),
                 rng.UniformInt(9), rng.UniformInt(9), rng.UniformInt(9)};
  pair.verdict = static_cast<PairVerdict>(rng.UniformInt(4));
  pair.cam_from_other = RandomPose(rng);
  pair.median_parallax_rad = rng.Uniform();
  pair.inliers = RandomMatches(num_features, rng);
  return pair;
}

inline OdometrySample RandomOdometry(Rng& rng) {
  OdometrySample sample{rng.Gaussian(), rng.Gaussian(), rng.Gaussian(), {}};
  if (rng.UniformInt(2) == 0) return sample;
  sample.covariance.emplace();
  for (double& value : *sample.covariance) value = rng.Gaussian();
  return sample;
}

inline FrameEvent RandomEvent(const FrameId& id, Rng& rng) {
  FrameEvent event;
  const uint32_t count = rng.UniformInt(20);
  event.id = id;
  event.kind = rng.UniformInt(3) == 0 ? FrameKind::kLight : FrameKind::kKeyframe;
  event.stamp_ns = static_cast<int64_t>(rng.Next() >> 1);
  event.image_name = "image " + std::to_string(rng.Next());
  event.camera_frame = rng.UniformInt(2) == 0 ? "" : "camera";
  event.camera = MakeSyntheticCamera();
  const bool is_light = event.kind == FrameKind::kLight;
  event.features = std::make_shared<FrameFeatures>(RandomFeatures(count, !is_light, rng));
  for (uint32_t i = 0; i < count; ++i)
    event.tracks.push_back(rng.Next() >> (1 + rng.UniformInt(60)));
  for (uint32_t i = is_light ? 0 : rng.UniformInt(4); i > 0; --i) {
    event.pairs.push_back(RandomPair(count, rng));
    event.links.push_back({1 + rng.UniformInt(1000), 1 + rng.UniformInt(1000)});
  }
  if (rng.UniformInt(2) == 0) event.odometry = RandomOdometry(rng);
  if (rng.UniformInt(2) == 0) event.base_from_camera = RandomPose(rng);
  event.blur = rng.Gaussian();
  if (rng.UniformInt(2) == 0) {
    event.jpeg = std::make_shared<std::vector<uint8_t>>(rng.UniformInt(50), uint8_t{7});
  }
  return event;
}

inline PlaceMatch RandomMatch(const FrameId& query, const FrameId& other, Rng& rng) {
  PlaceMatch match{query, rng.Uniform(), rng.Gaussian(), {}};
  for (uint32_t left = 1 + rng.UniformInt(3); left > 0; --left) {
    match.pairs.push_back({{other.drive, other.index + left},
                           static_cast<PairVerdict>(rng.UniformInt(4)),
                           RandomPose(rng),
                           RandomMatches(50, rng)});
  }
  return match;
}

inline MergeReport RandomReport(const FrameId& query, const FrameId& other, Rng& rng) {
  MergeReport report;
  report.kind = static_cast<MergeKind>(rng.UniformInt(3));
  report.verdict = static_cast<MergeVerdict>(rng.UniformInt(5));
  report.reason = "reason " + std::to_string(rng.Next());
  report.warning = rng.UniformInt(2) == 0 ? "" : "warning";
  report.query = query;
  report.other = other;
  report.query_session.value = rng.UniformInt(9);
  report.other_session.value = rng.UniformInt(9);
  for (uint32_t* count :
       {&report.num_candidates, &report.num_matches, &report.num_inliers, &report.num_common,
        &report.num_expected, &report.num_found, &report.num_links}) {
    *count = rng.UniformInt(1000);
  }
  report.by_resection = rng.UniformInt(2) == 0;
  const Rigid3 pose = RandomPose(rng);
  report.query_from_other = {rng.Uniform(0.5, 2.0), pose.rotation, pose.translation};
  report.sigma_log_scale = rng.Uniform();
  report.error_before_px = rng.Uniform();
  if (rng.UniformInt(2) == 0) report.error_after_px = rng.Uniform();
  return report;
}

inline std::vector<FeatureLink> RandomLinks(Rng& rng) {
  std::vector<FeatureLink> links(rng.UniformInt(6));
  for (FeatureLink& link : links) {
    link.a = {{1}, rng.UniformInt(100), rng.UniformInt(100)};
    link.b = {{2}, rng.UniformInt(100), rng.UniformInt(100)};
  }
  return links;
}

// Bytes of a column with every length and every bit changed. What is read of them must be written
// as the same bytes again; the rest must be refused with the column named. Returns how many were.
template <typename WriteAgain>
size_t CountRefused(const std::string& bytes, const std::string& column, const WriteAgain& again) {
  size_t num_refused = 0;
  const auto check = [&](const std::string& spoilt, const std::string& how) {
    try {
      EXPECT_EQ(again(BlobOf(spoilt)), spoilt) << column << ": " << how;
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()).rfind(column + ": ", 0), 0u) << how << error.what();
      ++num_refused;
    }
  };
  for (size_t size = 0; size < bytes.size(); ++size) {
    check(bytes.substr(0, size), "cut to " + std::to_string(size));
  }
  for (size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string spoilt = bytes;
    spoilt[bit / 8] = static_cast<char>(spoilt[bit / 8] ^ (1 << bit % 8));
    check(spoilt, "bit " + std::to_string(bit));
  }
  check(bytes + "x", "a byte more");
  return num_refused;
}

}  // namespace rovio_sfm
