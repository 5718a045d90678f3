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

void CheckLogin(const Credentials& credentials, const std::string& where) {
  for (const std::string* word : {&credentials.user, &credentials.password}) {
    if (word->size() > kMaxLength) {
      throw std::runtime_error(where + ": the robot takes 23 characters at most");
    }
    if (word->find('\r') != std::string::npos) {
      throw std::runtime_error(
          where +
          ": a line ends with a carriage return, as Windows writes it; save it "
          "with plain line feeds (sed -i 's/\\r$//' FILE)");
    }
  }
  if (credentials.user.find(':') != std::string::npos) {
    throw std::runtime_error(where + ": the user name holds a colon, which HTTP Basic cannot send");
  }
}

}  // namespace

Credentials LoadCredentials(const std::string& file) {
  if (file.empty()) {
    Credentials credentials{FromEnvironment("ROVIO_USER"), FromEnvironment("ROVIO_PASSWORD")};
    CheckLogin(credentials, "ROVIO_USER and ROVIO_PASSWORD");
    return credentials;
  }
  CheckMode(file);
  std::ifstream input(file);
  Credentials credentials;
  if (!std::getline(input, credentials.user) || !std::getline(input, credentials.password) ||
      credentials.user.empty()) {
    throw std::runtime_error("credentials_file " + file +
                             ": expected two lines, user and password");
  }
  CheckLogin(credentials, "credentials_file " + file);
  return credentials;
}

}  // namespace rovio_sfm
