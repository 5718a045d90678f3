#pragma once

#include <string>

#include "rovio_sfm/rovio/curl_transport.h"

namespace rovio_sfm {

// The login of the robot: from a file of two lines, user and password, that only its owner may read
// (mode 0600 or less); without a file from the environment, ROVIO_USER and ROVIO_PASSWORD; else
// empty. Throws std::runtime_error that names the file and the reason, never its content.
Credentials LoadCredentials(const std::string& file);

}  // namespace rovio_sfm
