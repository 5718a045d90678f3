#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/io/map_store_database.h"
#include "rovio_sfm/scene/ids.h"
#include "rovio_sfm/scene/match.h"
#include "rovio_sfm/util/binary_fields.h"

namespace rovio_sfm {

// The fields of which the store's columns are made.

// A frame is kept by the row of its drive; 0 for no frame.
using DriveRowOf = std::function<int64_t(const DriveId&)>;
using DriveAt = std::function<DriveId(int64_t)>;

constexpr uint32_t kMaxCount = 1u << 28;     // of anything that a column lists
constexpr double kMaxCoordinate = 1e9;       // no map is so large
constexpr double kMaxRotationExcess = 1e-3;  // of a quaternion's length over 1

inline FieldReader ReaderOf(const Blob& bytes, const char* column) {
  return FieldReader(static_cast<const uint8_t*>(bytes.data), bytes.size, column);
}

template <int N>
void WriteVector(const Eigen::Matrix<double, N, 1>& values, FieldWriter* writer) {
  for (const double value : values) writer->Write(value);
}

template <int N>
Eigen::Matrix<double, N, 1> ReadVector(const char* field, FieldReader* reader) {
  Eigen::Matrix<double, N, 1> values;
  for (double& value : values) {
    value = reader->ReadBetween<double>(field, -kMaxCoordinate, kMaxCoordinate);
  }
  return values;
}

inline void WritePose(const Rigid3& pose, FieldWriter* writer) {
  WriteVector<4>(pose.rotation.coeffs(), writer);
  WriteVector<3>(pose.translation, writer);
}

inline Rigid3 ReadPose(FieldReader* reader) {
  Rigid3 pose;
  pose.rotation.coeffs() = ReadVector<4>("rotation", reader);
  const double length = pose.rotation.norm();
  if (std::abs(length - 1.0) > kMaxRotationExcess) {
    reader->Fail("rotation: a quaternion of length " + std::to_string(length) + ": expected 1");
  }
  pose.translation = ReadVector<3>("translation", reader);
  return pose;
}

inline void WriteFrameId(const FrameId& id, const DriveRowOf& row_of, FieldWriter* writer) {
  writer->Write(id.drive.robot.empty() ? int64_t{0} : row_of(id.drive));
  writer->Write(id.index);
}

inline FrameId ReadFrameId(const DriveAt& drive_at, FieldReader* reader) {
  const auto row = reader->Read<int64_t>("drive");
  FrameId id;
  if (row != 0) id.drive = drive_at(row);
  id.index = reader->Read<uint32_t>("index");
  return id;
}

inline uint32_t ReadCount(const char* field, FieldReader* reader) {
  return reader->ReadBetween<uint32_t>(field, 0, kMaxCount);
}

inline void WriteMatches(const std::vector<FeatureMatch>& matches, FieldWriter* writer) {
  writer->Write(static_cast<uint32_t>(matches.size()));
  for (const FeatureMatch& match : matches) {
    writer->Write(match.a);
    writer->Write(match.b);
    writer->Write(match.distance);
    writer->Write(match.ratio);
  }
}

inline std::vector<FeatureMatch> ReadMatches(FieldReader* reader) {
  std::vector<FeatureMatch> matches;
  for (uint32_t left = ReadCount("matches", reader); left > 0; --left) {
    FeatureMatch match;
    match.a = reader->Read<uint32_t>("a");
    match.b = reader->Read<uint32_t>("b");
    match.distance = reader->Read<float>("distance");
    match.ratio = reader->Read<float>("ratio");
    matches.push_back(match);
  }
  return matches;
}

}  // namespace rovio_sfm
