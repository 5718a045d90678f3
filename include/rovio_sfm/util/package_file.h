#pragma once

#include <filesystem>
#include <optional>

namespace rovio_sfm {

// A file or folder that comes with the package: share/rovio_sfm/NAME below a parent of this
// program, as in an install space and in the devel space of a build. Nothing where there is none.
std::optional<std::filesystem::path> FindPackageFile(const std::filesystem::path& name);

}  // namespace rovio_sfm
