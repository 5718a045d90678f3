#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/app/web_request.h"

namespace rovio_sfm {

struct WebPolicy {
  std::vector<std::string>
      hosts;  // names that the page is called by, beside localhost and addresses
  bool allow_control = false;
  std::string token;  // of control; never empty where that is allowed
};

struct WebRefusal {
  int status = 403;
  std::string reason;  // one sentence
};

// Why a request is not answered; nothing where it may be. GET reads; POST controls: that needs the
// token and JSON. A Host that is neither localhost nor an address nor one of `hosts` is refused
// (DNS rebinding), an Origin that is not that host too, and what another site's page asks of /api/.
std::optional<WebRefusal> CheckRequest(const WebRequest& request, const WebPolicy& policy);

// In a time that tells nothing of where they differ.
bool EqualsInConstantTime(const std::string& given, const std::string& secret);

}  // namespace rovio_sfm
