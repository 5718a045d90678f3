#include "rovio_sfm/ros/frame_event_message.h"

#include <cmath>
#include <limits>

#include "rovio_sfm/ros/check_frame_event.h"
#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

uint16_t ToIndex(uint32_t feature) {
  ROVIO_CHECK(feature <= std::numeric_limits<uint16_t>::max(), "a frame has too many features");
  return static_cast<uint16_t>(feature);
}

uint32_t ToTrack(TrackId track) {
  ROVIO_CHECK(track <= std::numeric_limits<uint32_t>::max(), "a drive has too many tracks");
  return static_cast<uint32_t>(track);
}

PairMatchesMsg ToMessage(const PairMatches& pair) {
  PairMatchesMsg message;
  message.other_index = pair.other_index;
  message.num_features = pair.counts.features;
  message.num_ratio = pair.counts.ratio;
  message.num_percentile = pair.counts.percentile;
  message.num_one_to_one = pair.counts.one_to_one;
  message.num_ransac = pair.counts.ransac;
  message.num_guided = pair.counts.guided;
  message.verdict = static_cast<uint8_t>(pair.verdict);
  message.cam_from_other = ToTransform(pair.cam_from_other);
  message.median_parallax_rad = pair.median_parallax_rad;
  for (const FeatureMatch& match : pair.inliers) {
    message.inlier_other.push_back(ToIndex(match.a));
    message.inlier_this.push_back(ToIndex(match.b));
  }
  return message;
}

std::optional<PairMatches> FromMessage(const PairMatchesMsg& message, std::string* error) {
  std::string reason;
  const std::optional<Rigid3> cam_from_other = FromTransform(message.cam_from_other, &reason);
  const double length = cam_from_other ? cam_from_other->translation.norm() : 0.0;
  if (!cam_from_other || (length > 1e-9 && std::abs(length - 1.0) > 1e-3)) {
    *error = "pairs.cam_from_other: " + (reason.empty() ? "translation of length 0 or 1" : reason);
    return std::nullopt;
  }
  PairMatches pair;
  pair.other_index = message.other_index;
  pair.counts = {message.num_features,   message.num_ratio,  message.num_percentile,
                 message.num_one_to_one, message.num_ransac, message.num_guided};
  pair.verdict = static_cast<PairVerdict>(message.verdict);
  pair.cam_from_other = *cam_from_other;
  pair.median_parallax_rad = message.median_parallax_rad;
  for (size_t i = 0; i < message.inlier_this.size(); ++i) {
    pair.inliers.push_back({message.inlier_other[i], message.inlier_this[i], 0.0f, 1.0f});
  }
  return pair;
}

void WriteFeatures(const FrameEvent& event, FrameEventMsg* message) {
  const bool is_light = event.kind == FrameKind::kLight;
  for (const Keypoint& keypoint : event.features->keypoints) {
    message->x_px.push_back(keypoint.x_px);
    message->y_px.push_back(keypoint.y_px);
    message->size_px.push_back(keypoint.size_px);
    if (is_light) continue;
    message->angle_rad.push_back(keypoint.angle_rad);
    message->response.push_back(keypoint.response);
  }
  for (const TrackId track : event.tracks) message->tracks.push_back(ToTrack(track));
  if (is_light) return;
  for (const Rgb& color : event.features->colors) {
    message->rgb.insert(message->rgb.end(), color.begin(), color.end());
  }
  const Descriptors& descriptors = event.features->descriptors;
  message->descriptor_type = static_cast<uint8_t>(descriptors.type);
  message->descriptor_metric = static_cast<uint8_t>(descriptors.metric);
  message->descriptor_length = descriptors.length;
  message->descriptors = descriptors.data;
}

// The message is consistent; nothing where a pixel cannot be undistorted.
std::shared_ptr<const FrameFeatures> ReadFeatures(const FrameEventMsg& m, const Camera& camera) {
  auto features = std::make_shared<FrameFeatures>();
  features->colors.resize(m.x_px.size());
  for (size_t i = 0; i < m.x_px.size(); ++i) {
    const auto x_normalized = NormalizedFromPixel(camera, Eigen::Vector2d(m.x_px[i], m.y_px[i]));
    if (!x_normalized) return nullptr;
    const float angle_rad = m.angle_rad.empty() ? 0.0f : m.angle_rad[i];
    const float response = m.response.empty() ? 0.0f : m.response[i];
    features->keypoints.push_back(
        {m.x_px[i], m.y_px[i], m.size_px[i], angle_rad, response, *x_normalized});
    if (!m.rgb.empty()) features->colors[i] = {m.rgb[3 * i], m.rgb[3 * i + 1], m.rgb[3 * i + 2]};
  }
  features->descriptors = {static_cast<DescriptorType>(m.descriptor_type),
                           static_cast<DescriptorMetric>(m.descriptor_metric), m.descriptor_length,
                           m.descriptors};
  return features;
}

bool ReadPairs(const FrameEventMsg& message, FrameEvent* event, std::string* error) {
  for (const PairMatchesMsg& pair_message : message.pairs) {
    std::optional<PairMatches> pair = FromMessage(pair_message, error);
    if (!pair) return false;
    event->pairs.push_back(std::move(*pair));
  }
  for (size_t i = 0; i < message.link_a.size(); ++i) {
    event->links.push_back({message.link_a[i], message.link_b[i]});
  }
  return true;
}

// Odometry and the head's pose, where the message has them.
bool ReadRobot(const FrameEventMsg& message, FrameEvent* event, std::string* error) {
  std::string reason;
  if (message.has_odometry) {
    event->odometry = FromMessage(message.odometry, &reason);
    if (!event->odometry) *error = "odometry: " + reason;
  }
  if (message.has_base_from_camera) {
    event->base_from_camera = FromTransform(message.base_from_camera, &reason);
    if (!event->base_from_camera) *error = "base_from_camera: " + reason;
  }
  return reason.empty();
}

}  // namespace

FrameEventMsg ToMessage(const FrameEvent& event) {
  FrameEventMsg message;
  message.header.stamp = ToTime(event.stamp_ns);
  message.header.frame_id = event.camera_frame;
  message.format_version = FrameEventMsg::FORMAT_VERSION;
  message.id = ToMessage(event.id);
  message.kind = static_cast<uint8_t>(event.kind);
  message.image_name = event.image_name;
  message.camera = ToMessage(event.camera);
  WriteFeatures(event, &message);
  for (const PairMatches& pair : event.pairs) message.pairs.push_back(ToMessage(pair));
  for (const TrackLink& link : event.links) {
    message.link_a.push_back(ToTrack(link.a));
    message.link_b.push_back(ToTrack(link.b));
  }
  message.has_odometry = event.odometry.has_value();
  if (event.odometry) message.odometry = ToMessage(*event.odometry);
  message.has_base_from_camera = event.base_from_camera.has_value();
  if (event.base_from_camera) message.base_from_camera = ToTransform(*event.base_from_camera);
  message.blur = event.blur;
  if (event.jpeg) message.jpeg = *event.jpeg;
  return message;
}

std::optional<FrameEvent> FromMessage(const FrameEventMsg& message, std::string* error) {
  const std::optional<FrameId> id = FromMessage(message.id, error);
  if (!id) return std::nullopt;
  const std::optional<Camera> camera = FromMessage(message.camera, error);
  if (!camera || !IsConsistent(message, error)) return std::nullopt;
  FrameEvent event;
  event.features = ReadFeatures(message, *camera);
  if (event.features == nullptr) {
    *error = "x_px: expected pixels where the distortion can be inverted";
    return std::nullopt;
  }
  event.id = *id;
  event.kind = static_cast<FrameKind>(message.kind);
  event.stamp_ns = ToNanoseconds(message.header.stamp);
  event.image_name = message.image_name;
  event.camera_frame = message.header.frame_id;
  event.camera = *camera;
  event.tracks.assign(message.tracks.begin(), message.tracks.end());
  event.blur = message.blur;
  if (!message.jpeg.empty()) {
    event.jpeg = std::make_shared<const std::vector<uint8_t>>(message.jpeg);
  }
  if (!ReadPairs(message, &event, error) || !ReadRobot(message, &event, error)) return std::nullopt;
  return event;
}

}  // namespace rovio_sfm
