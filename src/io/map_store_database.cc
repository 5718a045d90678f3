#include "rovio_sfm/io/map_store_database.h"

#include <sqlite3.h>

namespace rovio_sfm {
namespace {

constexpr int kBusyTimeoutMs = 5000;  // while another process holds the file

int FlagsOf(StoreAccess access) {
  switch (access) {
    case StoreAccess::kCreate:
      return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    case StoreAccess::kWrite:
      return SQLITE_OPEN_READWRITE;
    case StoreAccess::kRead:
      break;
  }
  return SQLITE_OPEN_READONLY;
}

[[noreturn]] void ThrowError(const std::string& file, sqlite3* database) {
  throw StoreError(file + ": " + sqlite3_errmsg(database) + " (SQLite " +
                   std::to_string(sqlite3_extended_errcode(database)) + ")");
}

// What SQLite calls an I/O error, or unable; empty: it may be opened.
std::string WhyNoFile(const std::filesystem::path& path, StoreAccess access) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (std::filesystem::is_directory(status)) return "is a folder; expected a map store (map.db)";
  if (std::filesystem::is_other(status)) return "is no plain file; expected a map store (map.db)";
  if (std::filesystem::exists(status) || access == StoreAccess::kCreate) return "";
  return status.type() == std::filesystem::file_type::not_found ? "no such file" : error.message();
}

}  // namespace

Rows::~Rows() {
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
}

bool Rows::Next() {
  const int result = sqlite3_step(statement_);
  if (result == SQLITE_ROW) return true;
  if (result == SQLITE_DONE) return false;
  ThrowError(*file_, sqlite3_db_handle(statement_));
}

bool Rows::IsNull(int column) const {
  return sqlite3_column_type(statement_, column) == SQLITE_NULL;
}

int64_t Rows::Int(int column) const { return sqlite3_column_int64(statement_, column); }

double Rows::Double(int column) const { return sqlite3_column_double(statement_, column); }

std::string Rows::Text(int column) const {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
  if (text == nullptr) return "";
  return {text, static_cast<size_t>(sqlite3_column_bytes(statement_, column))};
}

Blob Rows::Bytes(int column) const {
  const void* data = sqlite3_column_blob(statement_, column);
  return {data, static_cast<size_t>(sqlite3_column_bytes(statement_, column))};
}

StoreDatabase::StoreDatabase(const std::filesystem::path& path, StoreAccess access,
                             const std::string& vfs)
    : file_(path.string()) {
  const std::string reason = vfs.empty() ? WhyNoFile(path, access) : "";
  if (!reason.empty()) throw StoreError(file_ + ": cannot be opened: " + reason);
  const int flags = FlagsOf(access) | SQLITE_OPEN_NOMUTEX;
  const char* const name = vfs.empty() ? nullptr : vfs.c_str();
  if (sqlite3_open_v2(path.c_str(), &database_, flags, name) == SQLITE_OK) {
    sqlite3_busy_timeout(database_, kBusyTimeoutMs);
    return;
  }
  const std::string cause = sqlite3_errmsg(database_);
  sqlite3_close(database_);
  throw StoreError(file_ + ": cannot be opened: " + cause);
}

StoreDatabase::~StoreDatabase() {
  for (const auto& [text, statement] : statements_) sqlite3_finalize(statement);
  sqlite3_close(database_);
}

void StoreDatabase::Execute(const std::string& script) {
  Require(sqlite3_exec(database_, script.c_str(), nullptr, nullptr, nullptr));
}

int64_t StoreDatabase::LastId() const { return sqlite3_last_insert_rowid(database_); }

bool StoreDatabase::IsInTransaction() const { return sqlite3_get_autocommit(database_) == 0; }

void StoreDatabase::RollBack() noexcept {
  if (IsInTransaction()) sqlite3_exec(database_, "ROLLBACK", nullptr, nullptr, nullptr);
}

sqlite3_stmt* StoreDatabase::Prepare(const char* text) {
  const auto known = statements_.find(std::string_view(text));
  if (known != statements_.end()) return known->second;
  sqlite3_stmt* statement = nullptr;
  Require(sqlite3_prepare_v3(database_, text, -1, SQLITE_PREPARE_PERSISTENT, &statement, nullptr));
  statements_.emplace(text, statement);
  return statement;
}

void StoreDatabase::Bind(sqlite3_stmt* statement, int index, int64_t value) {
  Require(sqlite3_bind_int64(statement, index, value));
}

void StoreDatabase::Bind(sqlite3_stmt* statement, int index, double value) {
  Require(sqlite3_bind_double(statement, index, value));
}

void StoreDatabase::Bind(sqlite3_stmt* statement, int index, const std::string& value) {
  Require(sqlite3_bind_text64(statement, index, value.data(), value.size(), SQLITE_TRANSIENT,
                              SQLITE_UTF8));
}

void StoreDatabase::Bind(sqlite3_stmt* statement, int index, const Blob& value) {
  Require(sqlite3_bind_blob64(statement, index, value.size == 0 ? "" : value.data, value.size,
                              SQLITE_STATIC));
}

void StoreDatabase::BindNull(sqlite3_stmt* statement, int index) {
  Require(sqlite3_bind_null(statement, index));
}

void StoreDatabase::Require(int result) const {
  if (result != SQLITE_OK) ThrowError(file_, database_);
}

}  // namespace rovio_sfm
