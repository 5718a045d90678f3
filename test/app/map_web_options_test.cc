#include "rovio_sfm/app/map_web_options.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "rovio_sfm/util/log.h"

namespace rovio_sfm {
namespace {

std::string ErrorOf(const std::string& yaml) {
  try {
    LoadMapWebOptions(YAML::Load(yaml));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

TEST(LoadMapWebOptions, ShowsToThisMachineOnlyByDefault) {
  const MapWebOptions options = LoadMapWebOptions(YAML::Load("{}"));
  EXPECT_EQ(options.address, "127.0.0.1");
  EXPECT_FALSE(options.allow_control);
}

TEST(LoadMapWebOptions, SaysWhatIsWrong) {
  EXPECT_EQ(ErrorOf("{port: 65536}"), "map_web.port = 65536: expected 0 to 65535");
  EXPECT_EQ(ErrorOf("{prot: 80}"), "map_web.prot: unknown key");
  EXPECT_EQ(ErrorOf("{token: short}"),
            "map_web.token = short: expected 16 characters or more, or none");
  EXPECT_EQ(ErrorOf("{image: ''}"), "map_web.image = : expected the name of a topic");
}

TEST(LoadMapWebOptions, LogsNoToken) {
  std::string logged;
  SetLogSink([&](LogLevel, const std::string& message) { logged += message + "\n"; });
  LoadMapWebOptions(YAML::Load("{token: 0123456789abcdef, port: 8091}"));
  SetLogSink([](LogLevel, const std::string&) {});
  EXPECT_NE(logged.find("8091"), std::string::npos);
  EXPECT_EQ(logged.find("0123456789abcdef"), std::string::npos) << logged;
}

}  // namespace
}  // namespace rovio_sfm
