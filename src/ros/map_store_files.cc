#include "rovio_sfm/ros/map_store_files.h"

#include <exception>

#include "rovio_sfm/app/store_folder.h"
#include "rovio_sfm/ros/conversions.h"
#include "rovio_sfm/ros/frame_event_message.h"
#include "rovio_sfm/ros/frame_page.h"
#include "rovio_sfm/ros/plain_name.h"
#include "rovio_sfm/ros/status.h"

namespace rovio_sfm {
namespace {

constexpr char kSuffix[] = ".db";

bool IsStoreName(const std::string& name) {
  const size_t length = sizeof(kSuffix) - 1;
  return IsPlainName(name) && name.size() > length &&
         name.compare(name.size() - length, length, kSuffix) == 0;
}

void AddPage(const StoredFrames& frames, const FrameId& first, uint32_t max_frames,
             FramePage* page) {
  for (const uint32_t index : frames.ReadIndices(first.drive, first.index, max_frames)) {
    const auto event = frames.ReadEvent({first.drive, index}, EventParts::kAll);
    if (event && !page->Add(ToMessage(*event))) return;
  }
}

}  // namespace

std::filesystem::path StorePathOf(const std::string& output_dir, const std::string& name,
                                  std::string* error) {
  const std::filesystem::path folder(output_dir);
  if (!IsStoreName(name)) {
    *error = "name = " + name + ": expected at most 64 of A-Z a-z 0-9 _ - . that end with .db";
  } else if (folder / name == StoreFolder::FileIn(folder)) {
    *error = "name = " + name + ": expected another than the store that is mapped into";
  } else {
    return folder / name;
  }
  return {};
}

SaveMapResponse CopyStore(const std::string& output_dir, const SaveMapRequest& request) {
  SaveMapResponse response;
  std::string error;
  const std::filesystem::path path = StorePathOf(output_dir, request.name, &error);
  if (path.empty()) {
    response.status = InvalidArgument(error);
    return response;
  }
  if (std::filesystem::is_directory(path)) {
    response.status = InvalidArgument("name = " + request.name + ": is a folder; expected a file");
    return response;
  }
  if (!request.overwrite && std::filesystem::exists(path)) {
    response.status = AlreadyExists(path.string() + " exists and overwrite was false");
    return response;
  }
  try {
    CopyStoreFile(StoreFolder::FileIn(output_dir), path);
    response.file = std::filesystem::absolute(path).string();
    response.status = Ok("all maps were copied to " + response.file);
  } catch (const std::exception& failure) {  // a full disk, a read-only folder
    response.status = Internal(failure.what());
  }
  return response;
}

GetFramesResponse PageOfStore(const std::string& output_dir, const GetFramesRequest& request) {
  GetFramesResponse response;
  std::string error;
  const auto first = FromMessage(request.first, &error);
  if (!first) {
    response.status = InvalidArgument("first." + error);
    return response;
  }
  try {
    MapStore store(StoreFolder::FileIn(output_dir), StoreAccess::kRead);
    FramePage page(request.max_frames);
    AddPage(store.frames(), *first, request.max_frames, &page);
    response = page.Take("no frame of that drive from that index on is kept");
  } catch (const std::exception& failure) {
    response.status = Internal(failure.what());
    return response;
  }
  if (response.frames.empty() || response.more) return response;
  response.more = true;
  response.next_index = response.frames.back().id.index + 1;
  return response;
}

}  // namespace rovio_sfm
