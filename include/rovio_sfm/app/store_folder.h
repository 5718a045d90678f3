#pragma once

#include <filesystem>
#include <memory>

#include "rovio_sfm/io/map_store.h"

namespace rovio_sfm {

// What becomes of the store that an output folder holds already.
enum class ExistingStore { kRefuse, kResume, kReplace };

// The maps of a folder on disk, held against every other process as long as this lives.
class StoreFolder {
 public:
  // Makes the folder, and opens or makes the store in it. Throws std::runtime_error where a store
  // is there and refused, or another process maps into it.
  StoreFolder(const std::filesystem::path& folder, ExistingStore existing,
              const MapStoreOptions& options = {});
  ~StoreFolder();
  StoreFolder(const StoreFolder&) = delete;
  StoreFolder& operator=(const StoreFolder&) = delete;

  static std::filesystem::path FileIn(const std::filesystem::path& folder);
  MapStore& store() { return *store_; }
  const MapStore& store() const { return *store_; }

  // Puts the store aside under another name in the folder, which it returns, and begins a new one.
  std::filesystem::path StartAnew();

 private:
  std::filesystem::path folder_;
  MapStoreOptions options_;
  int lock_ = -1;
  std::unique_ptr<MapStore> store_;
};

}  // namespace rovio_sfm
