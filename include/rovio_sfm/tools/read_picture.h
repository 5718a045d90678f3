#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "rovio_sfm/features/decode_image.h"

namespace rovio_sfm {

// Reads and decodes a picture of at most 64 MB. Where that fails the reason begins with the file's
// name; nothing is thrown.
DecodeResult ReadPicture(const std::filesystem::path& path, int64_t max_pixels);

// Says on the log that a picture is left out of what a tool does with many, and why.
void TellLeftOut(const std::string& reason);

}  // namespace rovio_sfm
