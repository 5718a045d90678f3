#pragma once

#include <string>
#include <utility>
#include <vector>

#include "rovio_sfm/sim/http/parameters.h"

namespace rovio_sfm::sim {

// The named values that one command answers. As in the firmware, values of one name stay together:
// when a name comes a second time, its first value moves to the end and the second follows it.
class ReplyFields {
 public:
  void Add(const std::string& name, const std::string& value);

  // "Name = Value\n" for each.
  std::string ToText() const;

 private:
  std::vector<std::pair<std::string, std::vector<std::string>>> groups_;
};

struct RenderedReply {
  std::string content_type;
  std::string body;
};

// The text as the request's options want it: JsVar=x makes it a JavaScript string, then OnJs=f adds
// a call; XML=x wraps it in an element (INFERRED; the serialiser is closed).
RenderedReply RenderReply(const std::string& text, const Parameters& options);

}  // namespace rovio_sfm::sim
