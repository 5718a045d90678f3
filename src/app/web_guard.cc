#include "rovio_sfm/app/web_guard.h"

#include <arpa/inet.h>

#include <algorithm>
#include <array>

namespace rovio_sfm {
namespace {

bool IsAddress(const std::string& name) {
  std::array<unsigned char, sizeof(in6_addr)> bytes;
  if (name.size() > 2 && name.front() == '[' && name.back() == ']') {
    return inet_pton(AF_INET6, name.substr(1, name.size() - 2).c_str(), bytes.data()) == 1;
  }
  return inet_pton(AF_INET, name.c_str(), bytes.data()) == 1;
}

std::string LowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

// "robots.local:8090" to "robots.local".
std::string WithoutPort(const std::string& host) {
  const size_t colon = host.rfind(':');
  const size_t bracket = host.rfind(']');
  const bool has_port = colon != std::string::npos &&
                        (bracket == std::string::npos ? host.find(':') == colon : colon > bracket);
  return has_port ? host.substr(0, colon) : host;
}

bool IsOurName(const std::string& host, const WebPolicy& policy) {
  const std::string name = LowerCase(WithoutPort(host));
  const auto is_same = [&](const std::string& own) { return LowerCase(own) == name; };
  return name == "localhost" || IsAddress(name) ||
         std::any_of(policy.hosts.begin(), policy.hosts.end(), is_same);
}

// What people may have typed, for a sentence: printable, short.
std::string Quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text.substr(0, 80)) quoted += c >= ' ' && c <= '~' ? c : '?';
  return quoted + "'";
}

std::optional<WebRefusal> CheckSource(const WebRequest& request, const WebPolicy& policy) {
  if (!IsOurName(request.host, policy)) {
    return WebRefusal{
        403, "Host " + Quoted(request.host) + ": expected localhost, an address or one of ~hosts"};
  }
  if (request.origin && LowerCase(*request.origin) != "http://" + LowerCase(request.host)) {
    return WebRefusal{403, "Origin " + Quoted(*request.origin) + ": expected http://" +
                               request.host + ", the page itself"};
  }
  const bool is_foreign =
      request.fetch_site && *request.fetch_site != "same-origin" && *request.fetch_site != "none";
  if (is_foreign && request.path != "/") {
    return WebRefusal{403, "Sec-Fetch-Site " + Quoted(*request.fetch_site) +
                               ": only this page itself may ask for " + Quoted(request.path)};
  }
  return std::nullopt;
}

std::optional<WebRefusal> CheckControl(const WebRequest& request, const WebPolicy& policy) {
  if (!policy.allow_control) {
    return WebRefusal{403, "this page only shows: map_web was started without allow_control"};
  }
  if (request.token.empty()) {
    return WebRefusal{401,
                      "no token: expected a header X-Rovio-Token; map_web logged it at its start"};
  }
  if (!EqualsInConstantTime(request.token, policy.token)) {
    return WebRefusal{401, "wrong token: expected the one that map_web logged at its start"};
  }
  if (request.content_type != "application/json" &&
      request.content_type.rfind("application/json;", 0) != 0) {
    return WebRefusal{
        415, "Content-Type " + Quoted(request.content_type) + ": expected application/json"};
  }
  return std::nullopt;
}

}  // namespace

std::optional<WebRefusal> CheckRequest(const WebRequest& request, const WebPolicy& policy) {
  if (auto refusal = CheckSource(request, policy)) return refusal;
  if (request.method == "GET") return std::nullopt;
  if (request.method == "POST") return CheckControl(request, policy);
  return WebRefusal{405, "method " + Quoted(request.method) + ": expected GET or POST"};
}

bool EqualsInConstantTime(const std::string& given, const std::string& secret) {
  if (given.empty() || secret.empty()) return given.size() == secret.size();
  unsigned different = given.size() == secret.size() ? 0u : 1u;
  for (size_t i = 0; i < given.size(); ++i) {
    different |= static_cast<unsigned char>(given[i]) ^
                 static_cast<unsigned>(static_cast<unsigned char>(secret[i % secret.size()]));
  }
  return different == 0;
}

}  // namespace rovio_sfm
