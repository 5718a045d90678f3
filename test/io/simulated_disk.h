#pragma once

#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "rovio_sfm/util/rng.h"

namespace rovio_sfm {

// A disk in memory that knows what a loss of power may leave of it: what was synced stays; of what
// was changed since, each change may be there, be missing, or be torn at sectors.
class SimulatedDisk {
 public:
  enum class Call { kOpen, kRead, kWrite, kTruncate, kSync, kDelete };
  using Bytes = std::vector<uint8_t>;
  // As processes see it, with the shared memory that goes with them.
  struct File {
    Bytes content;
    std::vector<std::unique_ptr<uint8_t[]>> shared;
  };

  // Asked before each call: true, and the call fails. Told before each sync takes effect.
  std::function<bool(Call)> fails = [](Call) { return false; };
  std::function<void()> before_sync = [] {};

  bool Exists(const std::string& name) const { return files_.count(name) != 0; }
  std::shared_ptr<File> Open(const std::string& name) {
    auto& file = files_[name];
    if (file == nullptr) {
      file = std::make_shared<File>();
      changes_.push_back({Kind::kCreate, name, 0, {}});
    }
    return file;
  }
  void Write(const std::string& name, File* file, size_t offset, const void* data, size_t size) {
    const auto* bytes = static_cast<const uint8_t*>(data);
    const Change change{Kind::kWrite, name, offset, Bytes(bytes, bytes + size)};
    Apply(change, kSectors, &file->content);
    if (!name.empty()) changes_.push_back(change);
  }
  void Truncate(const std::string& name, File* file, size_t size) {
    file->content.resize(size);
    if (!name.empty()) changes_.push_back({Kind::kTruncate, name, size, {}});
  }
  void Delete(const std::string& name, bool synced) {
    files_.erase(name);
    changes_.push_back({Kind::kDelete, name, 0, {}});
    if (synced) Sync(name);
  }
  void Sync(const std::string& name) {
    before_sync();
    TakeChanges(name, [this](const Change& change) { ApplyTo(change, kSectors, &durable_); });
  }
  // As Linux does it: what could not be written is never tried again.
  void FailToSync(const std::string& name) {
    TakeChanges(name, [](const Change&) {});
  }

  size_t num_changes() const { return changes_.size(); }
  // The files after a loss of power. Change i of those since the last syncs is missing (0), there
  // (1), or torn (2) where choices[i] says so.
  std::unique_ptr<SimulatedDisk> AfterCrash(const std::vector<uint8_t>& choices, Rng& rng) const {
    std::map<std::string, Bytes> left = durable_;
    for (size_t i = 0; i < changes_.size(); ++i) {
      if (choices[i] == 0) continue;
      ApplyTo(changes_[i], choices[i] == 1 ? kSectors : rng.Next(), &left);
    }
    auto disk = std::make_unique<SimulatedDisk>();
    disk->durable_ = left;
    for (auto& [name, content] : left) {
      disk->files_[name] = std::make_shared<File>();
      disk->files_[name]->content = std::move(content);
    }
    return disk;
  }

 private:
  enum class Kind { kCreate, kWrite, kTruncate, kDelete };
  struct Change {
    Kind kind;
    std::string name;
    size_t offset;
    Bytes bytes;
  };
  static constexpr size_t kSectorBytes = 512;
  static constexpr uint64_t kSectors = ~uint64_t{0};  // a bit each, over and over

  static void Apply(const Change& change, uint64_t sectors, Bytes* content) {
    for (size_t done = 0; done < change.bytes.size();) {
      const size_t at = change.offset + done;
      const size_t count = std::min(kSectorBytes - at % kSectorBytes, change.bytes.size() - done);
      if ((sectors >> (at / kSectorBytes) % 64 & 1) != 0) {
        if (content->size() < at + count) content->resize(at + count);
        std::memcpy(content->data() + at, change.bytes.data() + done, count);
      }
      done += count;
    }
  }
  static void ApplyTo(const Change& change, uint64_t sectors, std::map<std::string, Bytes>* files) {
    switch (change.kind) {
      case Kind::kCreate:
        (*files)[change.name];
        return;
      case Kind::kWrite:
        return Apply(change, sectors, &(*files)[change.name]);
      case Kind::kTruncate:
        (*files)[change.name].resize(change.offset);
        return;
      case Kind::kDelete:
        files->erase(change.name);
    }
  }
  template <typename Take>
  void TakeChanges(const std::string& name, const Take& take) {
    std::vector<Change> others;
    for (Change& change : changes_) {
      if (change.name == name) {
        take(change);
      } else {
        others.push_back(std::move(change));
      }
    }
    changes_ = std::move(others);
  }

  std::map<std::string, std::shared_ptr<File>> files_;
  std::map<std::string, Bytes> durable_;
  std::vector<Change> changes_;  // since the last sync of their file, oldest first
};

}  // namespace rovio_sfm
