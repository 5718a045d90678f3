#include "rovio_sfm/app/option_files.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace rovio_sfm {
namespace {

std::string FullPath(const OptionFile& file) {
  return std::string(ROVIO_SOURCE_DIR) + "/" + file.path;
}

std::string ShippedText(const OptionFile& file) {
  std::ostringstream text;
  text << std::ifstream(FullPath(file)).rdbuf();
  return text.str();
}

// With ROVIO_WRITE_OPTIONS in the environment (scripts/write_options) it writes them first.
TEST(WriteOptionFiles, GivesWhatIsShipped) {
  const bool writes = std::getenv("ROVIO_WRITE_OPTIONS") != nullptr;
  for (const OptionFile& file : WriteOptionFiles()) {
    if (writes) std::ofstream(FullPath(file)) << file.text;
    EXPECT_EQ(ShippedText(file), file.text) << file.path << ": run scripts/write_options";
  }
}

}  // namespace
}  // namespace rovio_sfm
