#include "rovio_sfm/sim/http/reply_fields.h"

#include <algorithm>

namespace rovio_sfm::sim {
namespace {

std::string EscapeForJavaScript(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\n') {
      escaped += "\\n";
    } else if (c == '\r') {
      escaped += "\\r";
    } else {
      if (c == '"' || c == '\\') escaped += '\\';
      escaped += c;
    }
  }
  return escaped;
}

std::string EscapeForXml(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

}  // namespace

void ReplyFields::Add(const std::string& name, const std::string& value) {
  const auto found = std::find_if(groups_.begin(), groups_.end(),
                                  [&](const auto& group) { return group.first == name; });
  if (found == groups_.end()) {
    groups_.push_back({name, {value}});
    return;
  }
  if (found->second.size() == 1) std::rotate(found, found + 1, groups_.end());
  const auto group = std::find_if(groups_.begin(), groups_.end(),
                                  [&](const auto& other) { return other.first == name; });
  group->second.push_back(value);
}

std::string ReplyFields::ToText() const {
  std::string text;
  for (const auto& [name, values] : groups_) {
    for (const std::string& value : values) text.append(name).append(" = ").append(value) += '\n';
  }
  return text;
}

RenderedReply RenderReply(const std::string& text, const Parameters& options) {
  const std::string variable = options.Get("JsVar");
  if (!variable.empty()) {
    std::string body = variable + "=\"" + EscapeForJavaScript(text) + "\";\n";
    const std::string callback = options.Get("OnJs");
    if (!callback.empty()) body += callback + "(this);\n";
    return {"text/plain", body};
  }
  const std::string element = options.Get("XML");
  if (!element.empty()) {
    return {"text/xml",
            "<XML Name=\"" + EscapeForXml(element) + "\">" + EscapeForXml(text) + "</XML>\n"};
  }
  return {"text/plain", text};
}

}  // namespace rovio_sfm::sim
