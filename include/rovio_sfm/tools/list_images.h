#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rovio_sfm {

// The image files (.jpg, .jpeg, .png, in whatever case) that the arguments name, folders replaced
// by their images in order of name. Throws std::runtime_error for what is neither, or where none is
// left.
std::vector<std::filesystem::path> ListImages(const std::vector<std::string>& arguments);

}  // namespace rovio_sfm
