#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rovio_sfm/app/live_parts.h"
#include "rovio_sfm/app/web_control.h"
#include "rovio_sfm/app/web_guard.h"
#include "rovio_sfm/app/web_request.h"

namespace rovio_sfm {

// What mapping said of an order.
struct ControlReply {
  bool is_done = false;
  std::string message;  // one sentence
};

struct WebSite {
  WebPolicy policy;
  std::vector<std::string> robots;  // those that have a camera
  std::string page;                 // HTML
  std::string instance;             // tells revisions of this run from those of another
};

// Answers requests of the live page (docs/ros_interface.md lists them) from the parts "status",
// "cloud", "scene/…" and "camera/ROBOT". What the client has already (?since=REVISION) is answered
// by 204. Thread-safe; the parts are borrowed. One order at a time: others are refused meanwhile.
class WebRouter {
 public:
  using Control = std::function<ControlReply(const ControlOrder&)>;

  WebRouter(WebSite site, const LiveParts* parts, Control control);

  WebAnswer Answer(const WebRequest& request);

 private:
  WebAnswer AnswerGet(const WebRequest& request) const;
  WebAnswer AnswerPost(const WebRequest& request);
  WebAnswer AnswerPart(const std::string& name, const std::string& content_type,
                       const WebRequest& request) const;
  WebAnswer AnswerScene(const WebRequest& request) const;
  WebAnswer AnswerCamera(const WebRequest& request) const;
  uint64_t RevisionOf(const std::string& since) const;
  std::string Tag(uint64_t revision) const;

  const WebSite site_;
  const std::shared_ptr<const std::string> page_;
  const LiveParts* parts_;
  const Control control_;
  std::atomic<bool> is_controlled_{false};
};

}  // namespace rovio_sfm
