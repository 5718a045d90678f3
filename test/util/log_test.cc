#include "rovio_sfm/util/log.h"

#include <gtest/gtest.h>

#include <iostream>
#include <utility>
#include <vector>

namespace rovio_sfm {
namespace {

TEST(Log, ReachesTheSinkWithItsLevel) {
  std::vector<std::pair<LogLevel, std::string>> seen;
  SetLogSink(
      [&](LogLevel level, const std::string& message) { seen.emplace_back(level, message); });
  LogDebug("a");
  LogInfo("b");
  LogWarning("c");
  LogError("d");
  SetLogSink([](LogLevel, const std::string& message) { std::cerr << message << "\n"; });
  const std::vector<std::pair<LogLevel, std::string>> expected = {{LogLevel::kDebug, "a"},
                                                                  {LogLevel::kInfo, "b"},
                                                                  {LogLevel::kWarning, "c"},
                                                                  {LogLevel::kError, "d"}};
  EXPECT_EQ(seen, expected);
}

}  // namespace
}  // namespace rovio_sfm
