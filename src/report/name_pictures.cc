#include "rovio_sfm/report/name_pictures.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <set>

#include "rovio_sfm/report/drive_names.h"

namespace rovio_sfm {
namespace {

constexpr size_t kMaxNameLength = 100;

bool HasPictureEnding(const std::string& name) {
  std::string ending = name.substr(std::min(name.rfind('.'), name.size()));
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".jpg" || ending == ".jpeg" || ending == ".png";
}

// The last part of a path; empty where it is no plain name of a picture.
std::string PlainName(const std::string& image_name) {
  const std::string name = image_name.substr(image_name.rfind('/') + 1);
  const bool is_plain = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
  });
  const bool fits = is_plain && name.size() <= kMaxNameLength && name.rfind('.', 0) != 0;
  return fits && name.rfind("frame_", 0) != 0 && HasPictureEnding(name) ? name : "";
}

std::string NumberedName(uint32_t index) {
  char name[32];
  std::snprintf(name, sizeof(name), "frame_%06u.jpg", index);
  return name;
}

}  // namespace

void NamePictures(const std::vector<std::string>& image_names, MapModel* model) {
  std::set<DriveId> drives;
  std::multiset<std::pair<DriveId, std::string>> uses;
  for (size_t i = 0; i < model->images.size(); ++i) {
    drives.insert(model->images[i].id.drive);
    uses.emplace(model->images[i].id.drive, PlainName(image_names[i]));
  }
  const std::map<DriveId, std::string> names = DriveNames(drives);
  for (size_t i = 0; i < model->images.size(); ++i) {
    ModelImage& image = model->images[i];
    const std::string plain = PlainName(image_names[i]);
    const bool is_own = !plain.empty() && uses.count({image.id.drive, plain}) == 1;
    image.name = names.at(image.id.drive) + "/" + (is_own ? plain : NumberedName(image.id.index));
  }
}

}  // namespace rovio_sfm
