#pragma once

#include <rovio_sfm/Status.h>

#include <filesystem>
#include <optional>
#include <string>

namespace rovio_sfm {

// The folder below output_dir that a request names; an empty name means output_dir itself. Nothing,
// and the status says why, where output_dir is not set or the name could lead elsewhere, links
// included.
std::optional<std::filesystem::path> FindExportFolder(const std::string& output_dir,
                                                      const std::string& name, Status* status);

}  // namespace rovio_sfm
