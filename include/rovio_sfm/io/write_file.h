#pragma once

#include <filesystem>
#include <string>

namespace rovio_sfm {

enum class Overwrite { kRefuse, kAllow };

// Writes all of content or nothing: temporary file beside the target, fsync, rename, fsync of the
// folder. Throws std::runtime_error with path and cause; refuses an existing file unless allowed.
void WriteFile(const std::filesystem::path& path, const std::string& content, Overwrite overwrite);

}  // namespace rovio_sfm
