#include "rovio_sfm/app/driver_credentials.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace rovio_sfm {
namespace {

class LoadCredentialsTest : public testing::Test {
 protected:
  void Write(const std::string& text, mode_t mode) {
    std::ofstream(path_) << text;
    chmod(path_.c_str(), mode);
  }
  ~LoadCredentialsTest() override { std::filesystem::remove(path_); }

  const std::string path_ = testing::TempDir() + "rovio_credentials_test";
};

TEST_F(LoadCredentialsTest, ReadsTwoLinesOfAFileThatIsItsOwnersOnly) {
  Write("admin\nsecret\n", 0600);
  const Credentials credentials = LoadCredentials(path_);
  EXPECT_EQ(credentials.user, "admin");
  EXPECT_EQ(credentials.password, "secret");
}

TEST_F(LoadCredentialsTest, RefusesAFileThatOthersMayRead) {
  Write("admin\nsecret\n", 0644);
  try {
    LoadCredentials(path_);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("chmod 600"), std::string::npos);
    EXPECT_EQ(std::string(error.what()).find("secret"), std::string::npos);
  }
}

TEST_F(LoadCredentialsTest, RefusesMissingAndMalformedFiles) {
  EXPECT_THROW(LoadCredentials(path_ + "_missing"), std::runtime_error);
  Write("admin", 0600);
  EXPECT_THROW(LoadCredentials(path_), std::runtime_error);
  Write("admin\n" + std::string(24, 'x') + "\n", 0600);
  EXPECT_THROW(LoadCredentials(path_), std::runtime_error);
}

TEST_F(LoadCredentialsTest, TellsWindowsLineEndsAndAColonInTheName) {
  const auto error_of = [this] {
    try {
      LoadCredentials(path_);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  Write("admin\r\nsecret\r\n", 0600);
  EXPECT_NE(error_of().find("carriage return"), std::string::npos);
  Write("ad:min\nsecret\n", 0600);
  EXPECT_NE(error_of().find("colon"), std::string::npos);
  EXPECT_EQ(error_of().find("secret"), std::string::npos);
  Write("admin\nse:cret\n", 0600);
  EXPECT_EQ(error_of(), "");
}

TEST_F(LoadCredentialsTest, TakesTheEnvironmentWithoutAFile) {
  setenv("ROVIO_USER", "guest", 1);
  setenv("ROVIO_PASSWORD", "word", 1);
  EXPECT_EQ(LoadCredentials("").user, "guest");
  EXPECT_EQ(LoadCredentials("").password, "word");
  unsetenv("ROVIO_USER");
  unsetenv("ROVIO_PASSWORD");
  EXPECT_TRUE(LoadCredentials("").user.empty());
}

}  // namespace
}  // namespace rovio_sfm
