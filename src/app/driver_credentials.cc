#include "rovio_sfm/app/driver_credentials.h"

#include <sys/stat.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace rovio_sfm {
namespace {

constexpr size_t kMaxLength = 23;  // the robot's own limit of names and passwords

std::string FromEnvironment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

void CheckMode(const std::string& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) {
    throw std::runtime_error("credentials_file " + file + ": cannot be read");
  }
  if (!S_ISREG(status.st_mode) || (status.st_mode & 0077) != 0) {
    throw std::runtime_error("credentials_file " + file +
                             ": must be a file that only its owner may read (chmod 600)");
  }
}

}  // namespace

Credentials LoadCredentials(const std::string& file) {
  if (file.empty()) return {FromEnvironment("ROVIO_USER"), FromEnvironment("ROVIO_PASSWORD")};
  CheckMode(file);
  std::ifstream input(file);
  Credentials credentials;
  if (!std::getline(input, credentials.user) || !std::getline(input, credentials.password) ||
      credentials.user.empty()) {
    throw std::runtime_error("credentials_file " + file +
                             ": expected two lines, user and password");
  }
  if (credentials.user.size() > kMaxLength || credentials.password.size() > kMaxLength) {
    throw std::runtime_error("credentials_file " + file +
                             ": the robot takes 23 characters at most");
  }
  return credentials;
}

}  // namespace rovio_sfm
