#include "rovio_sfm/ros/final_maps.h"

#include <ros/console.h>

#include <exception>

#include "rovio_sfm/util/stop_signals.h"

namespace rovio_sfm {
namespace {

std::filesystem::path ChooseFolder(const std::filesystem::path& output_dir, bool overwrite) {
  std::filesystem::path folder = output_dir;
  for (int i = 2; !overwrite && !FindMapFiles(folder).empty(); ++i) {
    folder = output_dir / ("run_" + std::to_string(i));
  }
  return folder;
}

}  // namespace

FinalMaps::FinalMaps(const std::filesystem::path& output_dir, bool overwrite)
    : folder_(ChooseFolder(output_dir, overwrite)),
      overwrite_(overwrite ? Overwrite::kAllow : Overwrite::kRefuse) {}

void FinalMaps::Write(const MapSnapshot& snapshot) {
  if (maps_.empty() && FindMapsBySize(snapshot).empty()) {  // older ones stay
    is_written_ = true;
    return;
  }
  const HoldSecondStop hold;
  try {
    maps_ = WriteAllMaps(snapshot, folder_, overwrite_);
    if (!maps_.empty()) overwrite_ = Overwrite::kAllow;  // from now on they are ours
    is_written_ = true;
  } catch (const std::exception& error) {  // a full disk
    is_written_ = false;
    ROS_ERROR_STREAM("maps not written: " << error.what());
  }
}

void FinalMaps::Tell(const std::vector<std::string>& why_not_metric) const {
  if (maps_.empty()) ROS_WARN("no map was written: no session has a posed frame");
  for (const WrittenMap& map : maps_) {
    ROS_INFO_STREAM(Describe(map));
    for (const std::filesystem::path& file : map.files) ROS_INFO_STREAM("wrote " << file.string());
  }
  for (const std::string& why : why_not_metric) ROS_WARN_STREAM("not metric: " << why);
}

}  // namespace rovio_sfm
