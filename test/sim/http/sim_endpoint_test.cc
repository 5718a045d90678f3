#include "rovio_sfm/sim/http/sim_endpoint.h"

#include <gtest/gtest.h>

#include "sim/http/face_fixture.h"

namespace rovio_sfm::sim {
namespace {

RoutedReply AskSim(FaceFixture& face, const std::string& query) {
  HttpRequest request;
  request.query = query;
  return AnswerSimRequest(request, face.context);
}

TEST(AnswerSimRequest, SwitchesQuirks) {
  FaceFixture face;
  EXPECT_EQ(AskSim(face, "quirk=stall&value=10").response.body, "stall = 10\n");
  EXPECT_TRUE(face.context.quirks.With(
      [&](Quirks& quirks) { return quirks.IsActive(Quirk::kStall, face.now_ns); }));
  EXPECT_NE(AskSim(face, "quirks").response.body.find("stall = 10\n"), std::string::npos);
}

TEST(AnswerSimRequest, RequireLoginSwitchesTheAccounts) {
  FaceFixture face;
  const auto is_checking = [&] {
    return face.context.accounts.With([](Accounts& accounts) { return accounts.is_checking(); });
  };
  AskSim(face, "quirk=require_login");
  EXPECT_TRUE(is_checking());
  AskSim(face, "quirk=none");
  EXPECT_FALSE(is_checking());
}

TEST(AnswerSimRequest, RebootSendsTheRobotAway) {
  FaceFixture face;
  EXPECT_EQ(AskSim(face, "quirk=reboot&value=1.5").away, std::chrono::milliseconds(1500));
  EXPECT_FALSE(AskSim(face, "quirk=reboot&value=0").away.has_value());
}

TEST(AnswerSimRequest, TellsTheTruth) {
  FaceFixture face;
  EXPECT_EQ(AskSim(face, "truth").response.body,
            "time_ns = 7\nworld_from_base = 1.5 -2 0 0 0 0 1\n"
            "world_from_camera = 0 0 0 0 0 0 1\n");
}

TEST(AnswerSimRequest, RefusesWhatItDoesNotKnow) {
  FaceFixture face;
  for (const char* bad : {"", "quirk=nonsense", "quirk=stall&value=x", "quirk=stall&value=-1"}) {
    EXPECT_EQ(AskSim(face, bad).response.status, 400) << bad;
  }
}

}  // namespace
}  // namespace rovio_sfm::sim
