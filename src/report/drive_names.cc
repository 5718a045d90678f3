#include "rovio_sfm/report/drive_names.h"

#include <algorithm>

namespace rovio_sfm {

std::map<DriveId, std::string> DriveNames(const std::set<DriveId>& drives) {
  std::map<DriveId, std::string> names;
  for (const DriveId& drive : drives) {
    const auto num_drives = std::count_if(drives.begin(), drives.end(), [&](const DriveId& other) {
      return other.robot == drive.robot;
    });
    names[drive] = num_drives > 1 ? drive.ToString() : drive.robot;
  }
  return names;
}

}  // namespace rovio_sfm
