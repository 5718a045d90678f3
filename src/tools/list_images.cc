#include "rovio_sfm/tools/list_images.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace rovio_sfm {
namespace {

bool IsImage(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension == ".jpg" || extension == ".jpeg" || extension == ".png";
}

std::vector<std::filesystem::path> ImagesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> images;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_regular_file() && IsImage(entry.path())) images.push_back(entry.path());
  }
  std::sort(images.begin(), images.end());
  return images;
}

}  // namespace

std::vector<std::filesystem::path> ListImages(const std::vector<std::string>& arguments) {
  std::vector<std::filesystem::path> images;
  for (const std::string& argument : arguments) {
    if (std::filesystem::is_directory(argument)) {
      const auto more = ImagesIn(argument);
      images.insert(images.end(), more.begin(), more.end());
    } else if (std::filesystem::is_regular_file(argument)) {
      images.emplace_back(argument);
    } else {
      throw std::runtime_error(argument + ": no such file or folder");
    }
  }
  if (images.empty()) throw std::runtime_error("no .jpg, .jpeg or .png among the arguments");
  return images;
}

}  // namespace rovio_sfm
