#include "rovio_sfm/util/log.h"

#include <iostream>
#include <utility>

namespace rovio_sfm {
namespace {

void WriteToStderr(LogLevel level, const std::string& message) {
  if (level < LogLevel::kWarning) return;
  std::cerr << (level == LogLevel::kError ? "error: " : "warning: ") << message << std::endl;
}

LogSink& Sink() {
  static LogSink sink = WriteToStderr;
  return sink;
}

}  // namespace

void SetLogSink(LogSink sink) { Sink() = std::move(sink); }
void LogDebug(const std::string& message) { Sink()(LogLevel::kDebug, message); }
void LogInfo(const std::string& message) { Sink()(LogLevel::kInfo, message); }
void LogWarning(const std::string& message) { Sink()(LogLevel::kWarning, message); }
void LogError(const std::string& message) { Sink()(LogLevel::kError, message); }

}  // namespace rovio_sfm
