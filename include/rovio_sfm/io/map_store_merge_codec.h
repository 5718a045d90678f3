#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "rovio_sfm/io/map_store_fields.h"
#include "rovio_sfm/scene/merge_edit.h"

namespace rovio_sfm {

// The bytes of the columns about merges, as in map_store_codec.h.

std::string MatchBytes(const PlaceMatch& match, const DriveRowOf& row_of);
PlaceMatch ReadMatch(const Blob& bytes, const DriveAt& drive_at);

std::string ReportBytes(const MergeReport& report, const DriveRowOf& row_of);
MergeReport ReadReport(const Blob& bytes, const DriveAt& drive_at);

std::string LinkBytes(const std::vector<FeatureLink>& links);
std::vector<FeatureLink> ReadLinks(const Blob& bytes);

std::string MarkBytes(const std::map<SessionId, uint32_t>& marks);
std::map<SessionId, uint32_t> ReadMarks(const Blob& bytes);

}  // namespace rovio_sfm
