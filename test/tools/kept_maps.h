#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "merging/two_drives.h"
#include "rovio_sfm/app/mapper.h"

namespace rovio_sfm {

// Two drives of 12 frames through a synthetic world, mapped into a store; merged where wanted.
// Robots may be named otherwise, so that two stores hold different drives.
inline void KeepTwoDrives(const std::filesystem::path& file, bool merged,
                          const std::string& prefix = "") {
  SyntheticDriveOptions options = TwoDrivesOptions(0.5);
  options.world.num_cams = 24;
  options.world.step = 0.1;
  TwoDrives two = MakeTwoDrives(options);
  MapStore store(file, StoreAccess::kCreate);
  Executor executor{0};
  Mapper mapper({}, &store, &executor);
  for (auto* events : {&two.a, &two.b}) {
    for (FrameEvent& event : *events) {
      event.id.drive.robot = prefix + event.id.drive.robot;
      event.jpeg = std::make_shared<const std::vector<uint8_t>>(100, uint8_t{1});
      mapper.Add(event);
    }
  }
  if (merged) mapper.Add(TrueOverlap(two, 8, 8));
  mapper.Finish();
  if (!mapper.SaveTo(&store)) ADD_FAILURE() << store.error();
}

inline void Spoil(const std::filesystem::path& file, const std::string& change) {
  StoreDatabase(file, StoreAccess::kWrite).Execute("PRAGMA foreign_keys = OFF;" + change);
}

// The maps of a store as a mapper takes them up.
inline std::shared_ptr<const MapSnapshot> MapsIn(const std::filesystem::path& file) {
  MapStore store(file, StoreAccess::kRead);
  Executor executor{0};
  Mapper mapper({}, &store, &executor);
  mapper.Restore(&store);
  return mapper.Snapshot();
}

}  // namespace rovio_sfm
