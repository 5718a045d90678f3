#include "rovio_sfm/ros/frame_event_message.h"

#include <gtest/gtest.h>
#include <ros/serialization.h>

#include <cmath>
#include <functional>
#include <limits>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Camera RovioCamera() { return {634.0, 629.0, 325.0, 259.0, 0.0218, -0.1098, 0, 0, 0, 640, 480}; }

std::shared_ptr<const FrameFeatures> RandomFeatures(const Camera& camera, size_t count,
                                                    bool has_descriptors, Rng* rng) {
  auto features = std::make_shared<FrameFeatures>();
  for (size_t i = 0; i < count; ++i) {
    Keypoint k;
    k.x_px = static_cast<float>(rng->Uniform(0.0, 639.0));
    k.y_px = static_cast<float>(rng->Uniform(0.0, 479.0));
    k.size_px = static_cast<float>(rng->Uniform(2.0, 30.0));
    if (has_descriptors) k.angle_rad = static_cast<float>(rng->Uniform(0.0, 6.28));
    if (has_descriptors) k.response = static_cast<float>(rng->Uniform());
    k.x_normalized = *NormalizedFromPixel(camera, Eigen::Vector2d(k.x_px, k.y_px));
    features->keypoints.push_back(k);
    features->colors.push_back(has_descriptors ? Rgb{1, 2, static_cast<uint8_t>(i)} : Rgb{});
  }
  if (!has_descriptors) return features;
  features->descriptors.type = DescriptorType::kSift;
  features->descriptors.length = 128;
  for (size_t i = 0; i < 128 * count; ++i) {
    features->descriptors.data.push_back(static_cast<uint8_t>(rng->UniformInt(256)));
  }
  return features;
}

PairMatches RandomPair(uint32_t other_index, size_t num_inliers, uint32_t num_features, Rng* rng) {
  PairMatches pair;
  pair.other_index = other_index;
  pair.counts = {num_features, 900, 800, 700, 600, 650};
  pair.verdict = PairVerdict::kPlanar;
  pair.cam_from_other = {Eigen::Quaterniond(0.8, 0.0, 0.6, 0.0), Eigen::Vector3d(0.6, 0.0, -0.8)};
  pair.median_parallax_rad = 0.05;
  for (size_t i = 0; i < num_inliers; ++i) {
    pair.inliers.push_back({rng->UniformInt(num_features), rng->UniformInt(num_features)});
  }
  return pair;
}

FrameEvent Keyframe(uint32_t num_features) {
  Rng rng(7);
  FrameEvent event;
  event.id = {{"rovio1", 1600000000123456789, 42}, 17};
  event.stamp_ns = 1600000001123456789;
  event.image_name = "000017.jpg";
  event.camera_frame = "rovio1/camera_optical";
  event.camera = RovioCamera();
  event.features = RandomFeatures(event.camera, num_features, true, &rng);
  for (uint32_t i = 0; i < num_features; ++i) event.tracks.push_back(i % 3);
  for (uint32_t i = 0; i < 8; ++i) {
    event.pairs.push_back(RandomPair(16 - i, 2 * num_features / 5, num_features, &rng));
  }
  event.links = {{1, 2}, {5, 9}};
  event.odometry = OdometrySample{1.0, -2.0, 0.5, OdometryCovariance{1, 0, 0, 0, 2, 0, 0, 0, 3}};
  event.base_from_camera =
      Rigid3{Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5), Eigen::Vector3d(0.1, 0.0, 0.2)};
  event.blur = 12.5;
  event.jpeg = std::make_shared<const std::vector<uint8_t>>(std::vector<uint8_t>{1, 2, 3});
  return event;
}

FrameEvent LightFrame(uint32_t num_features) {
  Rng rng(8);
  FrameEvent event = Keyframe(1);
  event.kind = FrameKind::kLight;
  event.features = RandomFeatures(event.camera, num_features, false, &rng);
  event.tracks.assign(num_features, 3);
  event.pairs.clear();
  event.links.clear();
  event.jpeg = nullptr;
  return event;
}

void ExpectSameRigid(const Rigid3& a, const Rigid3& b) {
  EXPECT_LT((a.translation - b.translation).norm(), 1e-12);
  EXPECT_LT(a.rotation.angularDistance(b.rotation), 1e-12);
}

void ExpectSameFeatures(const FrameFeatures& a, const FrameFeatures& b) {
  ASSERT_EQ(a.keypoints.size(), b.keypoints.size());
  for (size_t i = 0; i < a.keypoints.size(); ++i) {
    const Keypoint& k = a.keypoints[i];
    const Keypoint& l = b.keypoints[i];
    EXPECT_TRUE(k.x_px == l.x_px && k.y_px == l.y_px && k.size_px == l.size_px);
    EXPECT_TRUE(k.angle_rad == l.angle_rad && k.response == l.response);
    EXPECT_EQ(k.x_normalized, l.x_normalized);
  }
  EXPECT_EQ(a.colors, b.colors);
  EXPECT_EQ(a.descriptors.type, b.descriptors.type);
  EXPECT_EQ(a.descriptors.metric, b.descriptors.metric);
  EXPECT_EQ(a.descriptors.length, b.descriptors.length);
  EXPECT_EQ(a.descriptors.data, b.descriptors.data);
}

void ExpectSamePairs(const FrameEvent& a, const FrameEvent& b) {
  ASSERT_EQ(a.pairs.size(), b.pairs.size());
  for (size_t i = 0; i < a.pairs.size(); ++i) {
    EXPECT_EQ(a.pairs[i].other_index, b.pairs[i].other_index);
    EXPECT_EQ(a.pairs[i].verdict, b.pairs[i].verdict);
    EXPECT_EQ(a.pairs[i].counts.guided, b.pairs[i].counts.guided);
    EXPECT_EQ(a.pairs[i].median_parallax_rad, b.pairs[i].median_parallax_rad);
    ExpectSameRigid(a.pairs[i].cam_from_other, b.pairs[i].cam_from_other);
    ASSERT_EQ(a.pairs[i].inliers.size(), b.pairs[i].inliers.size());
    for (size_t j = 0; j < a.pairs[i].inliers.size(); ++j) {
      EXPECT_EQ(a.pairs[i].inliers[j].a, b.pairs[i].inliers[j].a);
      EXPECT_EQ(a.pairs[i].inliers[j].b, b.pairs[i].inliers[j].b);
    }
  }
}

void ExpectSameEvents(const FrameEvent& a, const FrameEvent& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.stamp_ns, b.stamp_ns);
  EXPECT_EQ(a.image_name, b.image_name);
  EXPECT_EQ(a.camera_frame, b.camera_frame);
  EXPECT_EQ(a.camera, b.camera);
  ExpectSameFeatures(*a.features, *b.features);
  EXPECT_EQ(a.tracks, b.tracks);
  ExpectSamePairs(a, b);
  ASSERT_EQ(a.links.size(), b.links.size());
  for (size_t i = 0; i < a.links.size(); ++i) {
    EXPECT_EQ(a.links[i].a, b.links[i].a);
    EXPECT_EQ(a.links[i].b, b.links[i].b);
  }
  ASSERT_TRUE(a.odometry && b.odometry && a.base_from_camera && b.base_from_camera);
  EXPECT_EQ(a.odometry->yaw_rad, b.odometry->yaw_rad);
  EXPECT_EQ(a.odometry->covariance, b.odometry->covariance);
  ExpectSameRigid(*a.base_from_camera, *b.base_from_camera);
  EXPECT_EQ(a.blur, b.blur);
  ASSERT_EQ(a.jpeg == nullptr, b.jpeg == nullptr);
  if (a.jpeg) {
    EXPECT_EQ(*a.jpeg, *b.jpeg);
  }
}

TEST(FrameEventMessage, RoundTripKeepsAKeyframe) {
  const FrameEvent event = Keyframe(100);
  std::string error;
  const auto back = FromMessage(ToMessage(event), &error);
  ASSERT_TRUE(back) << error;
  ExpectSameEvents(event, *back);
}

TEST(FrameEventMessage, RoundTripKeepsALightFrame) {
  const FrameEvent event = LightFrame(50);
  std::string error;
  const auto back = FromMessage(ToMessage(event), &error);
  ASSERT_TRUE(back) << error;
  ExpectSameEvents(event, *back);
}

TEST(FrameEventMessage, RoundTripKeepsMissingOdometryMissing) {
  FrameEvent event = Keyframe(10);
  event.odometry.reset();
  event.base_from_camera.reset();
  std::string error;
  const auto back = FromMessage(ToMessage(event), &error);
  ASSERT_TRUE(back) << error;
  EXPECT_FALSE(back->odometry);
  EXPECT_FALSE(back->base_from_camera);
}

TEST(FrameEventMessage, KeyframeOf1000FeaturesStaysBelow200Kilobytes) {
  FrameEvent event = Keyframe(1000);
  event.jpeg = nullptr;
  const uint32_t size = ros::serialization::serializationLength(ToMessage(event));
  EXPECT_LT(size, 200000u);
  RecordProperty("bytes", static_cast<int>(size));
}

TEST(FrameEventMessage, LightFrameOf500FeaturesStaysBelow10Kilobytes) {
  const uint32_t size = ros::serialization::serializationLength(ToMessage(LightFrame(500)));
  EXPECT_LT(size, 10000u);
  RecordProperty("bytes", static_cast<int>(size));
}

struct Refusal {
  std::string name;   // of the test
  std::string field;  // that the error must name
  std::function<void(FrameEventMsg*)> spoil;
};

class FrameEventRefusal : public testing::TestWithParam<Refusal> {};

TEST_P(FrameEventRefusal, NamesTheField) {
  FrameEventMsg message = ToMessage(Keyframe(20));
  GetParam().spoil(&message);
  std::string error;
  EXPECT_FALSE(FromMessage(message, &error));
  EXPECT_NE(error.find(GetParam().field), std::string::npos) << error;
}

INSTANTIATE_TEST_SUITE_P(
    Rules, FrameEventRefusal,
    testing::Values(
        Refusal{"OtherVersion", "format_version", [](auto* m) { m->format_version = 2; }},
        Refusal{"OddRobotName", "robot", [](auto* m) { m->id.drive.robot = "../etc"; }},
        Refusal{"LastIndex", "index", [](auto* m) { m->id.index = 4294967295u; }},
        Refusal{"UnknownKind", "kind", [](auto* m) { m->kind = 9; }},
        Refusal{"StampBeforeDrive", "header.stamp", [](auto* m) { m->header.stamp.sec = 5; }},
        Refusal{"LongName", "image_name", [](auto* m) { m->image_name.assign(300, 'a'); }},
        Refusal{"BlankInName", "image_name", [](auto* m) { m->image_name = "a b"; }},
        Refusal{"NanBlur", "blur", [](auto* m) { m->blur = kNan; }},
        Refusal{"NoFocalLength", "fx", [](auto* m) { m->camera.fx_px = 0.0; }},
        Refusal{"HugeImage", "width", [](auto* m) { m->camera.width = 4000000000u; }},
        Refusal{"ShortY", "y_px", [](auto* m) { m->y_px.pop_back(); }},
        Refusal{"ShortSize", "size_px", [](auto* m) { m->size_px.pop_back(); }},
        Refusal{"NoAngles", "angle_rad", [](auto* m) { m->angle_rad.clear(); }},
        Refusal{"ShortResponse", "response", [](auto* m) { m->response.pop_back(); }},
        Refusal{"ShortRgb", "rgb", [](auto* m) { m->rgb.pop_back(); }},
        Refusal{"ShortTracks", "tracks", [](auto* m) { m->tracks.pop_back(); }},
        Refusal{"NanKeypoint", "x_px", [](auto* m) { m->x_px[3] = kNan; }},
        Refusal{"KeypointOutside", "y_px", [](auto* m) { m->y_px[3] = 480.0f; }},
        Refusal{"NegativeSize", "size_px", [](auto* m) { m->size_px[0] = -1.0f; }},
        Refusal{"NanAngle", "angle_rad", [](auto* m) { m->angle_rad[0] = kNan; }},
        Refusal{"NanResponse", "response", [](auto* m) { m->response[0] = kNan; }},
        Refusal{"NoInverse", "x_px", [](auto* m) { m->camera.k1 = -5.0; }}),
    [](const auto& param_info) { return param_info.param.name; });

INSTANTIATE_TEST_SUITE_P(
    MatchRules, FrameEventRefusal,
    testing::Values(
        Refusal{"UnknownDescriptor", "descriptor_type", [](auto* m) { m->descriptor_type = 77; }},
        Refusal{"NoDescriptor", "descriptor_type", [](auto* m) { m->descriptor_type = 0; }},
        Refusal{"WrongMetric", "descriptor_type", [](auto* m) { m->descriptor_metric = 1; }},
        Refusal{"WrongLength", "descriptor_type", [](auto* m) { m->descriptor_length = 0; }},
        Refusal{"ShortDescriptors", "descriptors", [](auto* m) { m->descriptors.pop_back(); }},
        Refusal{"LightWithDescriptors", "descriptors", [](auto* m) { m->kind = 1; }},
        Refusal{"LaterOther", "other_index", [](auto* m) { m->pairs[0].other_index = 17; }},
        Refusal{"UnknownVerdict", "verdict", [](auto* m) { m->pairs[0].verdict = 4; }},
        Refusal{"UnevenInliers", "inlier", [](auto* m) { m->pairs[0].inlier_this.pop_back(); }},
        Refusal{"InlierOutside", "inlier_this", [](auto* m) { m->pairs[0].inlier_this[0] = 20; }},
        Refusal{"NanParallax", "parallax", [](auto* m) { m->pairs[0].median_parallax_rad = kNan; }},
        Refusal{"LongTranslation", "cam_from_other",
                [](auto* m) { m->pairs[0].cam_from_other.translation.x = 3.0; }},
        Refusal{"ZeroRotation", "cam_from_other",
                [](auto* m) { m->pairs[0].cam_from_other.rotation = {}; }},
        Refusal{"TooManyPairs", "pairs", [](auto* m) { m->pairs.resize(1001); }},
        Refusal{"UnevenLinks", "link_a", [](auto* m) { m->link_a.pop_back(); }},
        Refusal{"LinkToNoTrack", "link_a", [](auto* m) { m->link_b[0] = 0; }},
        Refusal{"NanOdometry", "odometry", [](auto* m) { m->odometry.x_m = kNan; }},
        Refusal{"NegativeVariance", "odometry", [](auto* m) { m->odometry.covariance[4] = -1.0; }},
        Refusal{"NanHead", "base_from_camera",
                [](auto* m) { m->base_from_camera.translation.z = kNan; }}),
    [](const auto& param_info) { return param_info.param.name; });

}  // namespace
}  // namespace rovio_sfm
