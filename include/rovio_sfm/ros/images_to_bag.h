#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "rovio_sfm/io/dataset_folder.h"

namespace rovio_sfm {

// Writes a data set as the bag that record.launch would have made of a drive: /<robot>/image_raw/
// compressed (the files' own bytes), /<robot>/camera_info, /<robot>/odom with all samples of
// odometry.txt, and /tf with base_link in odom at each of these and camera_optical in base_link at
// every image that knows it. Returns the number of images written, fewer after a signal. Throws
// std::runtime_error with path and cause, and leaves nothing then; refuses to replace a file unless
// `overwrite`.
size_t WriteBag(const DatasetFolder& dataset, const std::string& robot,
                const std::filesystem::path& bag_path, bool overwrite);

// The command images_to_bag; returns the exit status and throws like WriteBag.
int ImagesToBagCommand(int argc, const char* const* argv, std::ostream& out);

}  // namespace rovio_sfm
