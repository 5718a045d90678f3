#pragma once

#include <map>
#include <set>
#include <string>

#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {

// What drives are called in names of files: the robot, and where it has several among them all that
// tells them apart (DriveId::ToString).
std::map<DriveId, std::string> DriveNames(const std::set<DriveId>& drives);

}  // namespace rovio_sfm
