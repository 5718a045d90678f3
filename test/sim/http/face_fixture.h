#pragma once

#include <string>

#include "rovio_sfm/sim/http/request_router.h"
#include "rovio_sfm/sim/http/server_context.h"
#include "sim/http/fake_robot.h"

namespace rovio_sfm::sim {

// The handlers of a fake robot without any socket: asks by address, answers by value.
struct FaceFixture {
  FakeRobot robot;
  int64_t now_ns = 1'262'304'000'000'000'000;  // 1 January 2010
  ServerContext context{HttpFaceOptions(), robot, [this] { return now_ns; }};
  Caller caller{"", Privilege::kAdmin};

  RoutedReply Route(const std::string& target, const std::string& method = "GET") {
    auto request = ParseRequestHead(method + " " + target + " HTTP/1.0\r\n");
    return AnswerRequest(request.value(), caller, context);
  }
  std::string Ask(const std::string& target) { return Route(target).response.body; }
  int Status(const std::string& target) { return Route(target).response.status; }

  bool SetQuirk(const std::string& name, double value) {
    std::string error;
    return context.quirks.With(
        [&](Quirks& quirks) { return quirks.Set(name, value, now_ns, &error); });
  }
};

}  // namespace rovio_sfm::sim
