#include "rovio_sfm/tools/read_picture.h"

#include <stdexcept>

#include "rovio_sfm/io/text_file.h"
#include "rovio_sfm/util/log.h"

namespace rovio_sfm {
namespace {

constexpr uintmax_t kMaxImageBytes = 64u << 20;

}  // namespace

DecodeResult ReadPicture(const std::filesystem::path& path, int64_t max_pixels) {
  try {
    DecodeResult decoded = DecodeImage(ReadBytes(path, kMaxImageBytes), max_pixels);
    if (decoded.bgr.empty()) decoded.reason.insert(0, path.string() + ": ");
    return decoded;
  } catch (const std::runtime_error& error) {  // names the file
    return {cv::Mat(), error.what()};
  }
}

void TellLeftOut(const std::string& reason) { LogWarning("left out: " + reason); }

}  // namespace rovio_sfm
