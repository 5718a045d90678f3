#include "rovio_sfm/ros/replay.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tools/command_line.h"
#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

int Replay(int argc, const char* const* argv, std::ostream& out) {
  std::ostringstream progress;
  return ReplayCommand(argc, argv, out, progress);
}

std::string ErrorOf(const std::vector<std::string>& arguments) {
  std::string printed;
  try {
    RunCommand(Replay, arguments, &printed);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Replay, ExplainsItself) {
  std::string printed;
  EXPECT_EQ(RunCommand(Replay, {"--help"}, &printed), 0);
  EXPECT_NE(printed.find("--overwrite"), std::string::npos) << printed;
}

TEST(Replay, AsksForBags) {
  const std::string error = ErrorOf({});
  EXPECT_NE(error.find("bags"), std::string::npos) << error;
}

TEST(Replay, NamesABagThatIsNotThere) {
  const TemporaryFolder folder;
  const std::string error =
      ErrorOf({folder.Path() / "none.bag", "--places", "none", "--out", folder.Path() / "out"});
  EXPECT_NE(error.find("none.bag"), std::string::npos) << error;
}

TEST(Replay, ReplacesNoEarlierResult) {
  const TemporaryFolder folder;
  folder.Write("cloud.ply", "ply\n");
  const std::string error = ErrorOf({"some.bag", "--places", "none", "--out", folder.Path()});
  EXPECT_NE(error.find("--overwrite"), std::string::npos) << error;
}

}  // namespace
}  // namespace rovio_sfm
