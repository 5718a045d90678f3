#pragma once

#include <functional>
#include <string>

namespace rovio_sfm {

enum class LogLevel { kDebug, kInfo, kWarning, kError };

using LogSink = std::function<void(LogLevel, const std::string&)>;

// Where the core's messages go; the default writes warnings and errors to stderr. Call it once, at
// the start of main, before any thread logs.
void SetLogSink(LogSink sink);

void LogDebug(const std::string& message);
void LogInfo(const std::string& message);
void LogWarning(const std::string& message);
void LogError(const std::string& message);

}  // namespace rovio_sfm
