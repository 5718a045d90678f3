#include "rovio_sfm/app/output_folder.h"

#include <unistd.h>

#include <cstdlib>
#include <ctime>
#include <stdexcept>
#include <system_error>

#include "rovio_sfm/io/write_file.h"

namespace rovio_sfm {
namespace {

constexpr size_t kProbeBytes = 64u << 10;

std::string Environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::string LocalDate() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  char text[32];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%d_%H-%M-%S", &local)};
}

std::filesystem::path DefaultFolder(const OutputPlace& place) {
  const std::filesystem::path ros_home = place.ros_home.empty()
                                             ? std::filesystem::path(place.home) / ".ros"
                                             : std::filesystem::path(place.ros_home);
  const std::filesystem::path folder = ros_home / "rovio_sfm" / place.date;
  std::filesystem::path free = folder;
  for (int i = 2; std::filesystem::exists(free); ++i) {
    free = folder.string() + "_" + std::to_string(i);
  }
  return std::filesystem::absolute(free);
}

void RequireWritable(const std::filesystem::path& folder) {
  const std::filesystem::path probe = folder / (".probe." + std::to_string(::getpid()));
  try {
    WriteFile(probe, std::string(kProbeBytes, '\0'), Overwrite::kAllow);
  } catch (const std::system_error& error) {
    throw std::runtime_error(folder.string() + ": cannot be written: " + error.code().message());
  }
  std::filesystem::remove(probe);
}

void RequireRoom(const std::filesystem::path& folder, uintmax_t num_bytes) {
  const uintmax_t available = std::filesystem::space(folder).available;
  if (available >= num_bytes) return;
  throw std::runtime_error(folder.string() + ": " + std::to_string(available >> 20) +
                           " MB are free; expected at least " + std::to_string(num_bytes >> 20) +
                           " MB for the results");
}

}  // namespace

OutputPlace CurrentOutputPlace() {
  return {Environment("HOME"), Environment("ROS_HOME"), LocalDate()};
}

std::filesystem::path NodeOutputFolder(const std::string& parameter, const std::string& value,
                                       const OutputPlace& place) {
  if (value.empty()) return DefaultFolder(place);
  if (value == "~") return place.home;
  if (value.rfind("~/", 0) == 0) return std::filesystem::path(place.home) / value.substr(2);
  if (value.front() == '/') return value;
  throw std::runtime_error(parameter + ": '" + value +
                           "': expected an absolute path, or one that begins with ~/");
}

void RequireWritableFolder(const std::filesystem::path& folder, uintmax_t num_bytes) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw std::runtime_error(folder.string() + ": cannot be made: " + error.message());
  RequireWritable(folder);
  RequireRoom(folder, num_bytes);
}

}  // namespace rovio_sfm
