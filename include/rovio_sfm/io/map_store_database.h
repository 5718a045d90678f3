#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace rovio_sfm {

// A map store that cannot be read or written; the message names the file and the cause.
class StoreError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Bytes of a column. Borrowed.
struct Blob {
  const void* data = nullptr;
  size_t size = 0;
};
inline Blob BlobOf(const std::string& bytes) { return {bytes.data(), bytes.size()}; }
inline Blob BlobOf(const std::vector<uint8_t>& bytes) { return {bytes.data(), bytes.size()}; }

// The rows that a query gives. The next query of the same text, and the database's end, end it.
class Rows {
 public:
  Rows(sqlite3_stmt* statement, const std::string* file) : statement_(statement), file_(file) {}
  ~Rows();
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;

  bool Next();  // false: no more; throws StoreError
  bool IsNull(int column) const;
  int64_t Int(int column) const;
  double Double(int column) const;
  std::string Text(int column) const;
  Blob Bytes(int column) const;  // until the next row

 private:
  sqlite3_stmt* statement_;
  const std::string* file_;
};

// What a call throws, as a StoreError that names the file, once, and where in it.
template <typename Call>
auto WithFileNamed(const std::string& file, const Call& call, const std::string& where = "") {
  try {
    return call();
  } catch (const std::exception& error) {
    const std::string prefix = file + ": ", message = error.what();
    const bool is_named = message.compare(0, prefix.size(), prefix) == 0;
    throw StoreError(prefix + where + message.substr(is_named ? prefix.size() : 0));
  }
}

enum class StoreAccess { kCreate, kWrite, kRead };

// One SQLite file, with its statements prepared once. Whatever fails throws StoreError.
// Thread-compatible.
class StoreDatabase {
 public:
  // kCreate makes the file where it is missing; the others need it. How SQLite reaches files may be
  // named (a VFS that it knows); empty: as the system does.
  StoreDatabase(const std::filesystem::path& path, StoreAccess access, const std::string& vfs = "");
  ~StoreDatabase();
  StoreDatabase(const StoreDatabase&) = delete;
  StoreDatabase& operator=(const StoreDatabase&) = delete;

  const std::string& file() const { return file_; }

  // Several statements without parameters.
  void Execute(const std::string& script);
  // One statement that gives no rows.
  template <typename... Values>
  void Run(const char* text, const Values&... values) {
    Rows rows(Bound(text, values...), &file_);
    while (rows.Next()) {
    }
  }
  template <typename... Values>
  Rows Query(const char* text, const Values&... values) {
    return {Bound(text, values...), &file_};
  }
  int64_t LastId() const;
  bool IsInTransaction() const;
  void RollBack() noexcept;  // where a transaction is open

 private:
  template <typename... Values>
  sqlite3_stmt* Bound(const char* text, const Values&... values) {
    sqlite3_stmt* statement = Prepare(text);
    int index = 0;
    (Bind(statement, ++index, values), ...);
    return statement;
  }
  sqlite3_stmt* Prepare(const char* text);
  void Bind(sqlite3_stmt* statement, int index, int64_t value);
  void Bind(sqlite3_stmt* statement, int index, double value);
  void Bind(sqlite3_stmt* statement, int index, const std::string& value);
  void Bind(sqlite3_stmt* statement, int index, const Blob& value);  // of Run alone: not copied
  template <typename T>
  void Bind(sqlite3_stmt* statement, int index, const std::optional<T>& value) {
    value ? Bind(statement, index, *value) : BindNull(statement, index);
  }
  void Bind(sqlite3_stmt* statement, int index, uint32_t value) {
    Bind(statement, index, static_cast<int64_t>(value));
  }
  void Bind(sqlite3_stmt* statement, int index, int value) {
    Bind(statement, index, static_cast<int64_t>(value));
  }
  // Ids above 2^63 would come back negative: none is.
  void Bind(sqlite3_stmt* statement, int index, uint64_t value) {
    Bind(statement, index, static_cast<int64_t>(value));
  }
  void BindNull(sqlite3_stmt* statement, int index);
  void Require(int result) const;

  std::string file_;
  sqlite3* database_ = nullptr;
  std::map<std::string, sqlite3_stmt*, std::less<>> statements_;
};

// A column that holds one of the values up to `last`.
template <typename Enum>
Enum ReadEnum(const Rows& rows, int column, Enum last, const char* name) {
  const int64_t value = rows.Int(column);
  if (value >= 0 && value <= static_cast<int64_t>(last)) return static_cast<Enum>(value);
  throw StoreError(std::string(name) + " = " + std::to_string(value) + ": expected 0 to " +
                   std::to_string(static_cast<int64_t>(last)));
}

}  // namespace rovio_sfm
