#pragma once

#include <memory>
#include <optional>
#include <string>

namespace rovio_sfm {

// An HTTP request as far as the live page looks at it; headers that came twice are empty.
struct WebRequest {
  std::string method;  // GET, POST, …
  std::string path;    // without the query
  std::string since;   // of the query
  std::string host;
  std::optional<std::string> origin, fetch_site;  // headers Origin, Sec-Fetch-Site
  std::string token;                              // X-Rovio-Token
  std::string content_type;
  std::string body;
};

struct WebAnswer {
  int status = 200;
  std::string content_type;
  std::shared_ptr<const std::string> body;  // null: none
  std::string revision;                     // X-Revision; empty: none
};

}  // namespace rovio_sfm
