#include "rovio_sfm/sim/http/nav_library_actions.h"

#include <algorithm>
#include <cstdint>

#include "rovio_sfm/sim/robot/robot_backend.h"

namespace rovio_sfm::sim {
namespace {

constexpr size_t kMaxPaths = 20;
constexpr size_t kMaxNameBytes = 64;

std::string Code(NavResponse response) { return std::to_string(static_cast<int>(response)); }

std::string StartRecording(NavMemory& memory) {
  memory.is_recording = true;
  return Code(NavResponse::kSuccess);
}

std::string AbortRecording(NavMemory& memory) {
  const bool was_recording = std::exchange(memory.is_recording, false);
  return Code(was_recording ? NavResponse::kSuccess : NavResponse::kNotRecording);
}

std::string SavePath(NavMemory& memory, const std::string& name) {
  if (name.empty() || name.size() > kMaxNameBytes) return Code(NavResponse::kPathNameMissing);
  if (!memory.is_recording) return Code(NavResponse::kNotRecording);
  if (memory.paths.size() >= kMaxPaths) return "6";
  memory.is_recording = false;
  memory.paths.push_back(name);
  return "0|total_wp=0|quality=0|endpoints_dropped=0";
}

std::string DeletePath(NavMemory& memory, const std::string& name) {
  const auto found = std::find(memory.paths.begin(), memory.paths.end(), name);
  if (name.empty()) return Code(NavResponse::kPathNameMissing);
  if (found == memory.paths.end()) return Code(NavResponse::kPathNotFound);
  memory.paths.erase(found);
  return Code(NavResponse::kSuccess);
}

std::string ListPaths(const NavMemory& memory) {
  std::string text = "0";
  for (const std::string& path : memory.paths) text += "|" + path;
  return text;
}

std::string PlayPath(const NavMemory& memory, const std::string& name) {
  if (name.empty()) return Code(NavResponse::kPathNameMissing);
  const bool known = std::count(memory.paths.begin(), memory.paths.end(), name) > 0;
  return Code(known ? NavResponse::kNotImplemented : NavResponse::kPathNotFound);
}

std::string RenamePath(NavMemory& memory, const Parameters& parameters) {
  const std::string name = parameters.Get("name"), new_name = parameters.Get("newname");
  if (name.empty() || new_name.empty() || new_name.size() > kMaxNameBytes) {
    return Code(NavResponse::kPathNameMissing);
  }
  const auto found = std::find(memory.paths.begin(), memory.paths.end(), name);
  if (found == memory.paths.end()) return Code(NavResponse::kPathNotFound);
  *found = new_name;
  return Code(NavResponse::kSuccess);
}

std::string SetTuning(NavMemory& memory, const Parameters& parameters) {
  for (auto& [name, value] : memory.tuning) {
    if (parameters.Has(name)) value = parameters.GetLong(name).value_or(value);
  }
  return Code(NavResponse::kSuccess);
}

// Names with integers, spread over lines, blanks round the bar and the equals sign.
std::string GetTuning(const NavMemory& memory) {
  std::string text = "0";
  for (const auto& [name, value] : memory.tuning) {
    text += "\n | " + name + " = " + std::to_string(value);
  }
  return text;
}

std::string SetParameter(NavMemory& memory, const Parameters& parameters) {
  if (!parameters.Has("index") || !parameters.Has("value")) {
    return Code(NavResponse::kParameterMissing);
  }
  const auto index = parameters.GetLong("index");
  const auto value = parameters.GetLong("value");
  if (!index || *index < 0 || *index >= static_cast<long>(NavMemory::kNumParameters) || !value ||
      *value < INT32_MIN || *value > INT32_MAX) {
    return Code(NavResponse::kOutOfRange);
  }
  memory.parameters[static_cast<size_t>(*index)] = static_cast<int32_t>(*value);
  return Code(NavResponse::kSuccess);
}

std::string GetParameters(const NavMemory& memory, const Parameters& parameters) {
  const auto item = [&](size_t index) {
    return "|v" + std::to_string(index) + "=" + std::to_string(memory.parameters[index]);
  };
  std::string text = "0";
  if (!parameters.Has("index")) {
    for (size_t i = 0; i < NavMemory::kNumParameters; ++i) text += item(i);
    return text;
  }
  const long index = parameters.GetLong("index").value_or(-1);
  if (index < 0 || index >= static_cast<long>(NavMemory::kNumParameters)) {
    return Code(NavResponse::kOutOfRange);
  }
  return text + item(static_cast<size_t>(index));
}

std::string RunOn(NavMemory& memory, long action, const Parameters& parameters) {
  switch (action) {
    case 2:
      return StartRecording(memory);
    case 3:
      return AbortRecording(memory);
    case 4:
      return SavePath(memory, parameters.Get("name"));
    case 5:
      return DeletePath(memory, parameters.Get("name"));
    case 6:
      return ListPaths(memory);
    case 7:
    case 8:
      return PlayPath(memory, parameters.Get("name"));
    case 9:
    case 10:
      return Code(NavResponse::kSuccess);
    case 11:
      return RenamePath(memory, parameters);
    case 15:
      return SetTuning(memory, parameters);
    case 16:
      return GetTuning(memory);
    case 21:
      memory.paths.clear();
      return Code(NavResponse::kSuccess);
    case 23:
      return SetParameter(memory, parameters);
    case 24:
      return GetParameters(memory, parameters);
    case 25:
      return std::string(kNavLibraryVersion);
    case 26:
      return Code(NavResponse::kNotImplemented);
    default:
      return Code(NavResponse::kUnknownAction);
  }
}

}  // namespace

std::string RunNavLibraryAction(long action, const Parameters& parameters,
                                Guarded<NavMemory>& guarded) {
  return guarded.With([&](NavMemory& memory) { return RunOn(memory, action, parameters); });
}

}  // namespace rovio_sfm::sim
