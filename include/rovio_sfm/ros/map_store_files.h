#pragma once

#include <rovio_sfm/GetFrames.h>
#include <rovio_sfm/SaveMap.h>

#include <filesystem>
#include <string>

namespace rovio_sfm {

// The path of a store named by a request; empty, with the reason in error, where the name could
// lead elsewhere or means the store that is mapped into.
std::filesystem::path StorePathOf(const std::string& output_dir, const std::string& name,
                                  std::string* error);

// Answers the service SaveMap by a copy of the store of output_dir, as it was committed last. Never
// throws; the status says what went wrong.
SaveMapResponse CopyStore(const std::string& output_dir, const SaveMapRequest& request);

// Answers the service GetFrames by what was committed to the store of output_dir. A frame after
// those may be held elsewhere: `more` is true where there are any.
GetFramesResponse PageOfStore(const std::string& output_dir, const GetFramesRequest& request);

}  // namespace rovio_sfm
