#pragma once

#include <sqlite3.h>

#include <cstring>
#include <string>

#include "io/simulated_disk.h"

namespace rovio_sfm {

// SQLite's files on a simulated disk. Registered under kSimulatedVfs, never as the default. One
// process uses it: locks are always granted.
constexpr char kSimulatedVfs[] = "simulated_disk";

namespace simulated_vfs {

using Call = SimulatedDisk::Call;

struct OpenFile {
  sqlite3_file base;
  SimulatedDisk* disk;
  std::shared_ptr<SimulatedDisk::File>* file;
  std::string* name;  // empty: goes when it is closed
};

inline OpenFile* Of(sqlite3_file* file) { return reinterpret_cast<OpenFile*>(file); }
inline SimulatedDisk* DiskOf(sqlite3_vfs* vfs) {
  return static_cast<SimulatedDisk*>(vfs->pAppData);
}

inline int Close(sqlite3_file* file) {
  delete Of(file)->file;
  delete Of(file)->name;
  return SQLITE_OK;
}

inline int Read(sqlite3_file* file, void* data, int count, sqlite3_int64 offset) {
  if (Of(file)->disk->fails(Call::kRead)) return SQLITE_IOERR_READ;
  const SimulatedDisk::Bytes& content = (*Of(file)->file)->content;
  const auto size = static_cast<sqlite3_int64>(content.size());
  const sqlite3_int64 there =
      std::max<sqlite3_int64>(0, std::min<sqlite3_int64>(count, size - offset));
  std::memset(data, 0, static_cast<size_t>(count));
  if (there > 0) std::memcpy(data, content.data() + offset, static_cast<size_t>(there));
  return there == count ? SQLITE_OK : SQLITE_IOERR_SHORT_READ;
}

// What fails has been written by half.
inline int Write(sqlite3_file* file, const void* data, int count, sqlite3_int64 offset) {
  const bool fails = Of(file)->disk->fails(Call::kWrite);
  const int written = fails ? count / 2 : count;
  Of(file)->disk->Write(*Of(file)->name, Of(file)->file->get(), static_cast<size_t>(offset), data,
                        static_cast<size_t>(written));
  return fails ? SQLITE_FULL : SQLITE_OK;
}

inline int Truncate(sqlite3_file* file, sqlite3_int64 size) {
  if (Of(file)->disk->fails(Call::kTruncate)) return SQLITE_IOERR_TRUNCATE;
  Of(file)->disk->Truncate(*Of(file)->name, Of(file)->file->get(), static_cast<size_t>(size));
  return SQLITE_OK;
}

inline int Sync(sqlite3_file* file, int) {
  const bool fails = Of(file)->disk->fails(Call::kSync);
  if (fails) {
    Of(file)->disk->FailToSync(*Of(file)->name);
  } else {
    Of(file)->disk->Sync(*Of(file)->name);
  }
  return fails ? SQLITE_IOERR_FSYNC : SQLITE_OK;
}

inline int FileSize(sqlite3_file* file, sqlite3_int64* size) {
  *size = static_cast<sqlite3_int64>((*Of(file)->file)->content.size());
  return SQLITE_OK;
}

inline int Lock(sqlite3_file*, int) { return SQLITE_OK; }
inline int CheckReservedLock(sqlite3_file*, int* reserved) {
  *reserved = 0;
  return SQLITE_OK;
}
inline int FileControl(sqlite3_file*, int, void*) { return SQLITE_NOTFOUND; }
inline int SectorSize(sqlite3_file*) { return 4096; }  // as SQLite's own for Linux, and the next
inline int DeviceCharacteristics(sqlite3_file*) { return SQLITE_IOCAP_POWERSAFE_OVERWRITE; }

inline int ShmMap(sqlite3_file* file, int region, int size, int, void volatile** memory) {
  auto& shared = (*Of(file)->file)->shared;
  while (shared.size() <= static_cast<size_t>(region)) {
    shared.push_back(std::make_unique<uint8_t[]>(static_cast<size_t>(size)));
  }
  *memory = shared[static_cast<size_t>(region)].get();
  return SQLITE_OK;
}
inline int ShmLock(sqlite3_file*, int, int, int) { return SQLITE_OK; }
inline void ShmBarrier(sqlite3_file*) {}
inline int ShmUnmap(sqlite3_file* file, int is_last) {
  if (is_last != 0) (*Of(file)->file)->shared.clear();
  return SQLITE_OK;
}

inline int Open(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags, int* out_flags) {
  static const sqlite3_io_methods kMethods = {2,
                                              Close,
                                              Read,
                                              Write,
                                              Truncate,
                                              Sync,
                                              FileSize,
                                              Lock,
                                              Lock,
                                              CheckReservedLock,
                                              FileControl,
                                              SectorSize,
                                              DeviceCharacteristics,
                                              ShmMap,
                                              ShmLock,
                                              ShmBarrier,
                                              ShmUnmap,
                                              nullptr,
                                              nullptr};
  SimulatedDisk* disk = DiskOf(vfs);
  file->pMethods = nullptr;
  if (disk->fails(Call::kOpen)) return SQLITE_CANTOPEN;
  const bool is_named = name != nullptr;
  if (is_named && (flags & SQLITE_OPEN_CREATE) == 0 && !disk->Exists(name)) return SQLITE_CANTOPEN;
  Of(file)->disk = disk;
  Of(file)->name = new std::string(is_named ? name : "");
  Of(file)->file = new std::shared_ptr<SimulatedDisk::File>(
      is_named ? disk->Open(name) : std::make_shared<SimulatedDisk::File>());
  file->pMethods = &kMethods;
  if (out_flags != nullptr) *out_flags = flags;
  return SQLITE_OK;
}

inline int Delete(sqlite3_vfs* vfs, const char* name, int synced) {
  if (DiskOf(vfs)->fails(Call::kDelete)) return SQLITE_IOERR_DELETE;
  if (!DiskOf(vfs)->Exists(name)) return SQLITE_IOERR_DELETE_NOENT;
  DiskOf(vfs)->Delete(name, synced != 0);
  return SQLITE_OK;
}

inline int Access(sqlite3_vfs* vfs, const char* name, int, int* exists) {
  *exists = DiskOf(vfs)->Exists(name) ? 1 : 0;
  return SQLITE_OK;
}

inline int FullPathname(sqlite3_vfs*, const char* name, int size, char* full) {
  sqlite3_snprintf(size, full, "%s", name);
  return SQLITE_OK;
}

inline int Randomness(sqlite3_vfs*, int count, char* bytes) {
  static Rng rng(1);
  for (int i = 0; i < count; ++i) bytes[i] = static_cast<char>(rng.UniformInt(256));
  return count;
}

inline int Sleep(sqlite3_vfs*, int microseconds) { return microseconds; }
inline int CurrentTime(sqlite3_vfs*, double* days) {
  *days = 2460000.0;
  return SQLITE_OK;
}
inline int GetLastError(sqlite3_vfs*, int, char*) { return 0; }

}  // namespace simulated_vfs

// From now on the VFS reaches this disk. What is open stays on its own.
inline void UseSimulatedDisk(SimulatedDisk* disk) {
  namespace vfs = simulated_vfs;
  static sqlite3_vfs registered = [] {
    sqlite3_vfs made{};
    made.iVersion = 1;
    made.szOsFile = sizeof(vfs::OpenFile);
    made.mxPathname = 512;
    made.zName = kSimulatedVfs;
    made.xOpen = vfs::Open;
    made.xDelete = vfs::Delete;
    made.xAccess = vfs::Access;
    made.xFullPathname = vfs::FullPathname;
    made.xRandomness = vfs::Randomness;
    made.xSleep = vfs::Sleep;
    made.xCurrentTime = vfs::CurrentTime;
    made.xGetLastError = vfs::GetLastError;
    return made;
  }();
  registered.pAppData = disk;
  sqlite3_vfs_register(&registered, 0);
}

}  // namespace rovio_sfm
