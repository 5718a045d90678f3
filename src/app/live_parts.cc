#include "rovio_sfm/app/live_parts.h"

#include <algorithm>
#include <utility>

#include "rovio_sfm/util/text_ends.h"

namespace rovio_sfm {
void LiveParts::Set(const std::string& name, std::string bytes) {
  auto fresh = std::make_shared<const std::string>(std::move(bytes));
  const MutexLock lock(mutex_);
  LivePart& part = parts_[name];
  if (part.bytes != nullptr && *part.bytes == *fresh) return;
  part = {++revision_, std::move(fresh)};
  gone_.erase(name);
}

void LiveParts::Erase(const std::string& name) {
  const MutexLock lock(mutex_);
  if (parts_.erase(name) > 0) gone_[name] = ++revision_;
}

void LiveParts::EraseAll(const std::string& prefix) {
  const MutexLock lock(mutex_);
  for (auto part = parts_.lower_bound(prefix);
       part != parts_.end() && StartsWith(part->first, prefix); part = parts_.erase(part)) {
    gone_[part->first] = ++revision_;
  }
}

std::optional<LivePart> LiveParts::Find(const std::string& name) const {
  const MutexLock lock(mutex_);
  const auto part = parts_.find(name);
  if (part == parts_.end()) return std::nullopt;
  return part->second;
}

std::optional<LiveChanges> LiveParts::ChangesSince(uint64_t revision,
                                                   const std::string& prefix) const {
  LiveChanges changes;
  const MutexLock lock(mutex_);
  changes.revision = revision_;
  for (auto part = parts_.lower_bound(prefix);
       part != parts_.end() && StartsWith(part->first, prefix); ++part) {
    changes.names.push_back(part->first);
    if (part->second.revision > revision) changes.changed.insert(*part);
  }
  const bool has_lost = std::any_of(gone_.begin(), gone_.end(), [&](const auto& gone) {
    return gone.second > revision && StartsWith(gone.first, prefix);
  });
  if (changes.changed.empty() && !has_lost) return std::nullopt;
  return changes;
}

}  // namespace rovio_sfm
