#include "rovio_sfm/app/web_router.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "rovio_sfm/util/text_ends.h"

namespace rovio_sfm {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kApi[] = "/api/";
constexpr char kScene[] = "scene/";
constexpr char kCameraPath[] = "/api/camera/", kCameraEnd[] = ".jpg";
constexpr char kJson[] = "application/json";

WebAnswer Refuse(int status, const std::string& reason) {
  return {status, "text/plain; charset=utf-8", std::make_shared<const std::string>(reason + "\n"),
          ""};
}

WebAnswer AnswerJson(const Json& json) {
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return {200, kJson, std::make_shared<const std::string>(text), ""};
}

std::string JoinNames(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

// Parts are JSON already: they go into the answer as they are.
std::string SceneJson(const LiveChanges& changes) {
  Json names = Json::array();
  for (const std::string& name : changes.names) names.push_back(name.substr(sizeof(kScene) - 1));
  std::string text = "{\"names\":" + names.dump() + ",\"changed\":{";
  const char* separator = "";
  for (const auto& [name, part] : changes.changed) {
    text += separator + Json(name.substr(sizeof(kScene) - 1)).dump() + ":" + *part.bytes;
    separator = ",";
  }
  return text + "}}";
}

}  // namespace

WebRouter::WebRouter(WebSite site, const LiveParts* parts, Control control)
    : site_(std::move(site)),
      page_(std::make_shared<const std::string>(site_.page)),
      parts_(parts),
      control_(std::move(control)) {}

WebAnswer WebRouter::Answer(const WebRequest& request) {
  if (const auto refusal = CheckRequest(request, site_.policy)) {
    return Refuse(refusal->status, refusal->reason);
  }
  return request.method == "POST" ? AnswerPost(request) : AnswerGet(request);
}

WebAnswer WebRouter::AnswerGet(const WebRequest& request) const {
  if (request.path == "/") return {200, "text/html; charset=utf-8", page_, ""};
  if (request.path == "/api/status") return AnswerPart("status", kJson, request);
  if (request.path == "/api/cloud") return AnswerPart("cloud", kJson, request);
  if (request.path == "/api/paths") return AnswerScene(request);
  if (StartsWith(request.path, kCameraPath)) return AnswerCamera(request);
  if (StartsWith(request.path, kApi) && IsOrder(request.path.substr(sizeof(kApi) - 1))) {
    return Refuse(405, "method 'GET': expected POST, this changes the map");
  }
  return Refuse(404,
                "no such page: expected /, /api/status, /api/cloud, /api/paths or "
                "/api/camera/ROBOT.jpg");
}

WebAnswer WebRouter::AnswerPost(const WebRequest& request) {
  const std::string service =
      StartsWith(request.path, kApi) ? request.path.substr(sizeof(kApi) - 1) : "";
  if (!IsOrder(service)) return Refuse(404, "no such service: expected one of " + OrderNames());
  std::string error;
  const auto order = ParseOrder(service, request.body, &error);
  if (!order) return Refuse(400, service + ": " + error);
  if (is_controlled_.exchange(true)) {
    return Refuse(409, "mapping is still at what was asked before: ask again later");
  }
  const ControlReply reply = control_(*order);
  is_controlled_ = false;
  return AnswerJson({{"done", reply.is_done}, {"message", reply.message}});
}

// What is not there yet is told as what has not changed yet.
WebAnswer WebRouter::AnswerPart(const std::string& name, const std::string& content_type,
                                const WebRequest& request) const {
  const auto part = parts_->Find(name);
  if (!part || part->revision <= RevisionOf(request.since)) return {204, "", nullptr, ""};
  return {200, content_type, part->bytes, Tag(part->revision)};
}

WebAnswer WebRouter::AnswerScene(const WebRequest& request) const {
  const auto changes = parts_->ChangesSince(RevisionOf(request.since), kScene);
  if (!changes) return {204, "", nullptr, ""};
  return {200, kJson, std::make_shared<const std::string>(SceneJson(*changes)),
          Tag(changes->revision)};
}

WebAnswer WebRouter::AnswerCamera(const WebRequest& request) const {
  const std::string file = request.path.substr(sizeof(kCameraPath) - 1);
  const auto is_asked = [&](const std::string& robot) { return file == robot + kCameraEnd; };
  const auto robot = std::find_if(site_.robots.begin(), site_.robots.end(), is_asked);
  if (robot != site_.robots.end()) return AnswerPart("camera/" + *robot, "image/jpeg", request);
  return Refuse(404, "no such camera: expected ROBOT.jpg of one of " + JoinNames(site_.robots));
}

// What another run told, or nobody, is as nothing.
uint64_t WebRouter::RevisionOf(const std::string& since) const {
  const std::string begin = site_.instance + "-";
  uint64_t revision = 0;
  if (!StartsWith(since, begin)) return 0;
  const char* const last = since.data() + since.size();
  const auto [end, error] = std::from_chars(since.data() + begin.size(), last, revision);
  return error == std::errc() && end == last ? revision : 0;
}

std::string WebRouter::Tag(uint64_t revision) const {
  return site_.instance + "-" + std::to_string(revision);
}

}  // namespace rovio_sfm
