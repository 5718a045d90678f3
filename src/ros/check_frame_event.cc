#include "rovio_sfm/ros/check_frame_event.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rovio_sfm {
namespace {

constexpr size_t kMaxKeypoints = std::numeric_limits<uint16_t>::max();  // indices have 16 bits
constexpr size_t kMaxNameLength = 256;
constexpr uint32_t kNoIndex = std::numeric_limits<uint32_t>::max();  // there is always a next one
constexpr size_t kMaxPairs = 1000;
constexpr size_t kMaxLinks = 100000;
constexpr size_t kMaxJpegBytes = 64u << 20;

bool RefuseField(const std::string& field, const std::string& expected, std::string* error) {
  *error = field + ": expected " + expected;
  return false;
}

bool AllFinite(const std::vector<float>& values) {
  return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

// An array with one entry per keypoint; a light frame may leave some out.
bool HasSize(const char* field, size_t size, size_t expected, bool may_be_empty,
             std::string* error) {
  if (size == expected || (may_be_empty && size == 0)) return true;
  return RefuseField(
      field,
      "one entry per keypoint (" + std::to_string(expected) + "), got " + std::to_string(size),
      error);
}

bool HasConsistentHeader(const FrameEventMsg& m, std::string* error) {
  if (m.format_version != FrameEventMsg::FORMAT_VERSION) {
    return RefuseField(
        "format_version",
        std::to_string(FrameEventMsg::FORMAT_VERSION) + ", got " + std::to_string(m.format_version),
        error);
  }
  if (m.id.index == kNoIndex) return RefuseField("index", "less than 4294967295", error);
  if (m.kind != FrameEventMsg::KEYFRAME && m.kind != FrameEventMsg::LIGHT) {
    return RefuseField("kind", "KEYFRAME or LIGHT", error);
  }
  if (m.header.stamp < m.id.drive.start) {
    return RefuseField("header.stamp", "not before the drive's start", error);
  }
  const bool is_text = std::all_of(m.image_name.begin(), m.image_name.end(),
                                   [](unsigned char c) { return c > ' ' && c != 127; });
  if (m.image_name.size() > kMaxNameLength || !is_text) {
    return RefuseField("image_name", "at most 256 characters without blanks", error);
  }
  if (!std::isfinite(m.blur)) return RefuseField("blur", "a finite number", error);
  if (m.jpeg.size() > kMaxJpegBytes) return RefuseField("jpeg", "at most 64 MiB", error);
  return true;
}

bool HasConsistentSizes(const FrameEventMsg& m, std::string* error) {
  const size_t count = m.x_px.size();
  const bool is_light = m.kind == FrameEventMsg::LIGHT;
  if (count > kMaxKeypoints) return RefuseField("x_px", "at most 65535 keypoints", error);
  return HasSize("y_px", m.y_px.size(), count, false, error) &&
         HasSize("size_px", m.size_px.size(), count, false, error) &&
         HasSize("angle_rad", m.angle_rad.size(), count, is_light, error) &&
         HasSize("response", m.response.size(), count, is_light, error) &&
         HasSize("rgb", m.rgb.size(), 3 * count, is_light, error) &&
         HasSize("tracks", m.tracks.size(), count, false, error);
}

bool HasKeypointsInImage(const FrameEventMsg& m, std::string* error) {
  const auto is_within = [](const std::vector<float>& values, uint32_t size) {
    return std::all_of(values.begin(), values.end(), [size](float v) {
      return v >= -0.5f && v <= static_cast<float>(size) - 0.5f;  // false for NaN
    });
  };
  if (!is_within(m.x_px, m.camera.width)) return RefuseField("x_px", "pixels in the image", error);
  if (!is_within(m.y_px, m.camera.height)) return RefuseField("y_px", "pixels in the image", error);
  const auto is_size = [](float v) { return v >= 0.0f && v < 1e5f; };
  if (!std::all_of(m.size_px.begin(), m.size_px.end(), is_size)) {
    return RefuseField("size_px", "0 to 1e5 px", error);
  }
  if (!AllFinite(m.angle_rad)) return RefuseField("angle_rad", "finite numbers", error);
  if (!AllFinite(m.response)) return RefuseField("response", "finite numbers", error);
  return true;
}

bool IsKnownDescriptor(const FrameEventMsg& m) {
  const auto is = [&](uint8_t metric, uint32_t low, uint32_t high) {
    return m.descriptor_metric == metric && m.descriptor_length >= low &&
           m.descriptor_length <= high;
  };
  switch (m.descriptor_type) {
    case FrameEventMsg::SIFT:
      return is(FrameEventMsg::L2, 128, 128);
    case FrameEventMsg::ORB:
      return is(FrameEventMsg::HAMMING, 32, 32);
    case FrameEventMsg::AKAZE:
      return is(FrameEventMsg::HAMMING, 8, 64);
    case FrameEventMsg::SURF:
      return is(FrameEventMsg::L2, 64, 64);
    default:
      return false;
  }
}

bool HasConsistentDescriptors(const FrameEventMsg& m, std::string* error) {
  if (m.kind == FrameEventMsg::LIGHT) {
    const bool is_bare = m.descriptor_type == FrameEventMsg::NONE && m.descriptors.empty();
    return is_bare || RefuseField("descriptors", "none in a light frame", error);
  }
  if (!IsKnownDescriptor(m)) {
    return RefuseField("descriptor_type", "a known type with its metric and length", error);
  }
  return HasSize("descriptors", m.descriptors.size(), m.x_px.size() * m.descriptor_length, false,
                 error);
}

bool IsConsistentPair(const FrameEventMsg& m, const PairMatchesMsg& pair, std::string* error) {
  if (pair.other_index >= m.id.index) {
    return RefuseField("pairs.other_index", "an earlier frame", error);
  }
  if (pair.verdict > PairMatchesMsg::ROTATION) {
    return RefuseField("pairs.verdict", "FAILED, GENERAL, PLANAR or ROTATION", error);
  }
  if (pair.inlier_other.size() != pair.inlier_this.size()) {
    return RefuseField("pairs.inlier_other", "as many entries as inlier_this", error);
  }
  const auto is_index = [&](uint16_t i) { return i < m.x_px.size(); };
  if (!std::all_of(pair.inlier_this.begin(), pair.inlier_this.end(), is_index)) {
    return RefuseField("pairs.inlier_this", "indices of keypoints", error);
  }
  if (!(pair.median_parallax_rad >= 0.0 && pair.median_parallax_rad < 3.2)) {
    return RefuseField("pairs.median_parallax_rad", "0 to pi", error);
  }
  return true;
}

bool HasConsistentPairs(const FrameEventMsg& m, std::string* error) {
  if (m.pairs.size() > kMaxPairs) return RefuseField("pairs", "at most 1000", error);
  if (m.link_a.size() != m.link_b.size() || m.link_a.size() > kMaxLinks) {
    return RefuseField("link_a", "as many entries as link_b, at most 100000", error);
  }
  if (m.kind == FrameEventMsg::LIGHT && (!m.pairs.empty() || !m.link_a.empty())) {
    return RefuseField("pairs", "neither pairs nor links in a light frame", error);
  }
  const auto is_track = [](uint32_t id) { return id != 0; };
  if (!std::all_of(m.link_a.begin(), m.link_a.end(), is_track) ||
      !std::all_of(m.link_b.begin(), m.link_b.end(), is_track)) {
    return RefuseField("link_a", "tracks, counted from 1", error);
  }
  return std::all_of(m.pairs.begin(), m.pairs.end(),
                     [&](const PairMatchesMsg& pair) { return IsConsistentPair(m, pair, error); });
}

}  // namespace

bool IsConsistent(const FrameEventMsg& message, std::string* error) {
  return HasConsistentHeader(message, error) && HasConsistentSizes(message, error) &&
         HasKeypointsInImage(message, error) && HasConsistentDescriptors(message, error) &&
         HasConsistentPairs(message, error);
}

}  // namespace rovio_sfm
