#include "rovio_sfm/ros/export_folder.h"

#include "rovio_sfm/ros/plain_name.h"
#include "rovio_sfm/ros/status.h"

namespace rovio_sfm {
namespace {

// Where links in the folder lead elsewhere, nothing is written.
bool StaysInside(const std::filesystem::path& folder, const std::filesystem::path& output_dir) {
  const std::filesystem::path inside = std::filesystem::weakly_canonical(folder).lexically_relative(
      std::filesystem::weakly_canonical(output_dir));
  return !inside.empty() && *inside.begin() != "..";
}

}  // namespace

std::optional<std::filesystem::path> FindExportFolder(const std::string& output_dir,
                                                      const std::string& name, Status* status) {
  if (output_dir.empty()) {
    *status = FailedPrecondition("the parameter ~output_dir is not set");
    return std::nullopt;
  }
  if (!name.empty() && !IsPlainName(name)) {
    *status = InvalidArgument("name = " + name +
                              ": expected at most 64 of A-Z a-z 0-9 _ - ., "
                              "not beginning with .");
    return std::nullopt;
  }
  const std::filesystem::path folder = std::filesystem::path(output_dir) / name;
  if (!StaysInside(folder, output_dir)) {
    *status =
        InvalidArgument("name: " + folder.string() + " is a link that leads out of " + output_dir);
    return std::nullopt;
  }
  std::error_code ignored;  // what cannot be looked at cannot be written either, which is told then
  if (std::filesystem::exists(folder, ignored) && !std::filesystem::is_directory(folder, ignored)) {
    *status = InvalidArgument("name = " + name + ": is a file; expected a folder or nothing yet");
    return std::nullopt;
  }
  return folder;
}

}  // namespace rovio_sfm
