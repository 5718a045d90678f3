#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "rovio_sfm/frontend/frontend_options.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/tools/second_look.h"
#include "rovio_sfm/util/executor.h"

namespace rovio_sfm {

// Called in the caller's thread: which step, and how much of it is done.
using TrainingProgress = std::function<void(const std::string& step, size_t done, size_t total)>;

// Descriptors of training images, and of second looks at some of them.
struct TrainingFeatures {
  std::vector<Descriptors> images;
  std::vector<uint32_t> looked_at;  // images[looked_at[i]] is what second_looks[i] shows again
  std::vector<Descriptors> second_looks;
};

// Decodes, denoises and extracts as the live frontend does. The seed decides on the second looks;
// the threads change nothing. Images that cannot be read are left out and named on the log. Throws
// std::runtime_error where none is left.
TrainingFeatures ExtractTrainingFeatures(const std::vector<std::filesystem::path>& images,
                                         const FrontendOptions& frontend,
                                         const SecondLookOptions& second_look, uint64_t seed,
                                         Executor* executor, const TrainingProgress& progress);

// At most max_count features of all images, evenly thinned.
Descriptors ThinFeatures(const std::vector<Descriptors>& images, size_t max_count);

}  // namespace rovio_sfm
