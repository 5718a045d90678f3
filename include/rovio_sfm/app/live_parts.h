#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/util/mutex.h"

namespace rovio_sfm {

// The newest bytes of one thing that a live page shows; the revision is that of its last change.
struct LivePart {
  uint64_t revision = 0;
  std::shared_ptr<const std::string> bytes;
};

// What of a group of parts changed after a revision, and which there are.
struct LiveChanges {
  uint64_t revision = 0;  // of now
  std::map<std::string, LivePart> changed;
  std::vector<std::string> names;
};

// The parts of a live page by name, "status" or "scene/path_3". Every change raises the revision;
// bytes that are the same change nothing. Thread-safe: nobody waits longer than a copy of pointers.
class LiveParts {
 public:
  void Set(const std::string& name, std::string bytes) EXCLUDES(mutex_);
  void Erase(const std::string& name) EXCLUDES(mutex_);
  // All whose names begin so.
  void EraseAll(const std::string& prefix) EXCLUDES(mutex_);

  std::optional<LivePart> Find(const std::string& name) const EXCLUDES(mutex_);
  // Of the parts whose names begin so; a part that went is missed in `names` alone. Nothing where
  // none changed or went.
  std::optional<LiveChanges> ChangesSince(uint64_t revision, const std::string& prefix) const
      EXCLUDES(mutex_);

 private:
  mutable Mutex mutex_;
  uint64_t revision_ GUARDED_BY(mutex_) = 0;
  std::map<std::string, LivePart> parts_ GUARDED_BY(mutex_);
  std::map<std::string, uint64_t> gone_ GUARDED_BY(mutex_);  // when
};

}  // namespace rovio_sfm
