#include "rovio_sfm/sim/robot/image_folder_backend.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "rovio_sfm/util/log.h"

namespace rovio_sfm::sim {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> ListJpegs(const fs::path& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string extension = it->path().extension().string();
    if (extension == ".jpg" || extension == ".jpeg") paths.push_back(it->path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::vector<uint8_t> ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

std::unique_ptr<ImageFolderBackend> ImageFolderBackend::Open(const std::string& folder,
                                                             bool repeats, std::string* error) {
  std::error_code ignored;
  const fs::path inner = fs::path(folder) / "images";
  auto paths = ListJpegs(fs::is_directory(inner, ignored) ? inner : fs::path(folder));
  if (paths.empty()) {
    *error = "no JPEG images in " + folder;
    return nullptr;
  }
  return std::unique_ptr<ImageFolderBackend>(new ImageFolderBackend(std::move(paths), repeats));
}

ImageFolderBackend::ImageFolderBackend(std::vector<std::string> paths, bool repeats)
    : paths_(std::move(paths)), repeats_(repeats) {}

void ImageFolderBackend::AdvanceTo(int64_t time_ns) { time_ns_ = time_ns; }

NavResponse ImageFolderBackend::Drive(const DriveCommand&) { return NavResponse::kSuccess; }

void ImageFolderBackend::MoveHead(HeadPosition target) {
  constexpr uint8_t kUp = 65, kMiddle = 135, kDown = 204;
  reading_.head_position = target == HeadPosition::kUp       ? kUp
                           : target == HeadPosition::kMiddle ? kMiddle
                                                             : kDown;
}

void ImageFolderBackend::SwitchHeadlight(bool on) { reading_.headlight = on; }

void ImageFolderBackend::SwitchInfrared(bool on) { reading_.infrared = on; }

TruePose ImageFolderBackend::ReadTruth() const {
  TruePose truth;
  truth.time_ns = time_ns_;
  return truth;
}

std::optional<CapturedImage> ImageFolderBackend::Capture(int64_t time_ns, const CameraSettings&) {
  if (next_ >= paths_.size()) {
    if (!repeats_) return std::nullopt;
    next_ = 0;
  }
  CapturedImage image{time_ns, ReadFile(paths_[next_])};
  if (image.jpeg.empty()) LogWarning("cannot read " + paths_[next_]);
  ++next_;
  if (image.jpeg.empty()) return std::nullopt;
  return image;
}

}  // namespace rovio_sfm::sim
