#include "rovio_sfm/app/web_router.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace rovio_sfm {
namespace {

constexpr char kToken[] = "0123456789abcdef";

class WebRouterTest : public ::testing::Test {
 protected:
  static WebSite Site() {
    WebSite site;
    site.policy.allow_control = true;
    site.policy.token = kToken;
    site.robots = {"rovio1", "rovio2"};
    site.page = "<html>";
    site.instance = "run";
    return site;
  }

  WebAnswer Get(const std::string& path, const std::string& since = "") {
    WebRequest request;
    request.method = "GET";
    request.path = path;
    request.since = since;
    request.host = "localhost";
    return router_.Answer(request);
  }

  WebAnswer Post(const std::string& path, const std::string& body) {
    WebRequest request;
    request.method = "POST";
    request.path = path;
    request.host = "localhost";
    request.token = kToken;
    request.content_type = "application/json";
    request.body = body;
    return router_.Answer(request);
  }

  LiveParts parts_;
  std::vector<ControlOrder> orders_;
  std::function<void()> meanwhile_;
  WebRouter router_{Site(), &parts_, [this](const ControlOrder& order) {
                      orders_.push_back(order);
                      if (meanwhile_) meanwhile_();
                      return ControlReply{true, "as told"};
                    }};
};

TEST_F(WebRouterTest, ServesThePage) {
  const WebAnswer answer = Get("/");
  EXPECT_EQ(answer.status, 200);
  EXPECT_EQ(*answer.body, "<html>");
  EXPECT_EQ(answer.content_type, "text/html; charset=utf-8");
}

TEST_F(WebRouterTest, SendsOnlyWhatTheClientHasNot) {
  EXPECT_EQ(Get("/api/cloud").status, 204);
  parts_.Set("cloud", "{\"count\":0}");
  const WebAnswer first = Get("/api/cloud");
  EXPECT_EQ(first.status, 200);
  EXPECT_EQ(*first.body, "{\"count\":0}");
  EXPECT_EQ(Get("/api/cloud", first.revision).status, 204);
  parts_.Set("cloud", "{\"count\":1}");
  EXPECT_EQ(*Get("/api/cloud", first.revision).body, "{\"count\":1}");
}

TEST_F(WebRouterTest, RevisionsOfAnotherRunAreAsNone) {
  parts_.Set("status", "{}");
  for (const char* since :
       {"", "other-900", "run", "run-", "run-x", "run-9x", "run-99999999999999999999"}) {
    EXPECT_EQ(Get("/api/status", since).status, 200) << since;
  }
  EXPECT_EQ(Get("/api/status", "run-1").status, 204);
}

TEST_F(WebRouterTest, TellsWhichPartsOfTheSceneThereAre) {
  EXPECT_EQ(Get("/api/paths").status, 204);
  parts_.Set("scene/path_1", "[1]");
  parts_.Set("scene/path_2", "[2]");
  parts_.Set("status", "{}");
  const WebAnswer all = Get("/api/paths");
  EXPECT_EQ(*all.body, R"({"names":["path_1","path_2"],"changed":{"path_1":[1],"path_2":[2]}})");
  parts_.Erase("scene/path_1");
  EXPECT_EQ(*Get("/api/paths", all.revision).body, R"({"names":["path_2"],"changed":{}})");
}

TEST_F(WebRouterTest, ServesTheCamerasOfItsRobots) {
  EXPECT_EQ(Get("/api/camera/rovio2.jpg").status, 204);
  parts_.Set("camera/rovio2", "\xff\xd8");
  EXPECT_EQ(*Get("/api/camera/rovio2.jpg").body, "\xff\xd8");
  EXPECT_EQ(Get("/api/camera/rovio2.jpg").content_type, "image/jpeg");
  for (const char* name : {"rovio3.jpg", "rovio2", "../rovio2.jpg", ".jpg", ""}) {
    const WebAnswer answer = Get(std::string("/api/camera/") + name);
    EXPECT_EQ(answer.status, 404) << name;
    EXPECT_EQ(*answer.body, "no such camera: expected ROBOT.jpg of one of rovio1, rovio2\n");
  }
}

TEST_F(WebRouterTest, HandsOnOrders) {
  const WebAnswer answer = Post("/api/merge_sessions", R"({"session_a": 1, "session_b": 2})");
  EXPECT_EQ(answer.status, 200);
  EXPECT_EQ(*answer.body, R"({"done":true,"message":"as told"})");
  ASSERT_EQ(orders_.size(), 1u);
  EXPECT_EQ(std::get<MergeSessionsOrder>(orders_[0]).session_b, 2u);
}

TEST_F(WebRouterTest, RefusesWhatIsNoOrder) {
  EXPECT_EQ(Get("/api/save_map").status, 405);
  EXPECT_EQ(Post("/api/reset", "{}").status, 404);
  EXPECT_EQ(Post("/", "{}").status, 404);
  EXPECT_EQ(Post("/api/status", "{}").status, 404);
  const WebAnswer answer = Post("/api/unmerge_session", "{\"session\": 0}");
  EXPECT_EQ(answer.status, 400);
  EXPECT_EQ(*answer.body,
            "unmerge_session: session = 0: expected the number of a session, from 1\n");
  EXPECT_EQ(Get("/etc/passwd").status, 404);
  EXPECT_TRUE(orders_.empty());
}

TEST_F(WebRouterTest, TakesOneOrderAtATime) {
  const std::string body = R"({"session": 1})";
  meanwhile_ = [&] {
    meanwhile_ = nullptr;
    EXPECT_EQ(Post("/api/unmerge_session", body).status, 409);
  };
  EXPECT_EQ(Post("/api/unmerge_session", body).status, 200);
  EXPECT_EQ(Post("/api/unmerge_session", body).status, 200);
  EXPECT_EQ(orders_.size(), 2u);
}

}  // namespace
}  // namespace rovio_sfm
