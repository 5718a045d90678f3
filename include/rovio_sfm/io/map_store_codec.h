#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "rovio_sfm/io/map_store_database.h"
#include "rovio_sfm/scene/drive_state.h"
#include "rovio_sfm/scene/events.h"
#include "rovio_sfm/scene/session_parts.h"

namespace rovio_sfm {

// The bytes of the store's columns, little-endian and unpadded; docs/map_store.md says what each
// holds. Readers throw std::runtime_error that names the column where the bytes do not fit.

std::string PoseBytes(const Rigid3& pose);
Rigid3 ReadPose(const Blob& bytes);

std::string OdometryBytes(const OdometrySample& sample);
OdometrySample ReadOdometry(const Blob& bytes);

std::string TrackBytes(const std::vector<TrackId>& tracks);
std::vector<TrackId> ReadTracks(const Blob& bytes);

std::string KeypointBytes(const FrameFeatures& features);
FrameFeatures ReadKeypoints(const Blob& bytes);  // without descriptors

std::string InlierBytes(const std::vector<FeatureMatch>& inliers);
std::vector<FeatureMatch> ReadInliers(const Blob& bytes);

std::string DriveStateBytes(const DriveState& state);
DriveState ReadDriveState(const Blob& bytes);

// Landmarks with ids from first to before end.
std::string LandmarkBytes(const std::map<TrackId, Landmark>& landmarks, TrackId first, TrackId end);
void ReadLandmarks(const Blob& bytes, std::map<TrackId, Landmark>* landmarks);

}  // namespace rovio_sfm
