#include "rovio_sfm/sim/http/request_router.h"

#include <gtest/gtest.h>

#include "sim/http/face_fixture.h"

namespace rovio_sfm::sim {
namespace {

TEST(AnswerRequest, RunsSeveralCommandsInOrder) {
  FaceFixture face;
  EXPECT_EQ(face.Ask("/rev.cgi?Cmd=nav&action=22&Cmd=GetCamera.cgi&Cmd=nav&action=18"),
            "Cmd = nav\nresponses = 0 | state=0\nCmd = GetCamera.cgi\nFrequency = 50\n"
            "Cmd = nav\nresponses = 23\n");
}

TEST(AnswerRequest, DropsUnknownCommandsSilently) {
  FaceFixture face;
  EXPECT_EQ(face.Status("/rev.cgi?Cmd=nonsense"), 200);
  EXPECT_EQ(face.Ask("/rev.cgi?Cmd=nonsense"), "");
  EXPECT_EQ(face.Ask("/Cmd.cgi"), "");
  EXPECT_EQ(face.Ask("/rev.cgi?Cmd=nonsense&a=1&Cmd=GetCamera.cgi"),
            "Cmd = GetCamera.cgi\nFrequency = 50\n");
}

TEST(AnswerRequest, TakesCommandsByTheirOwnPathWithoutPrefix) {
  FaceFixture face;
  EXPECT_EQ(face.Ask("/nav?action=22"), "responses = 0 | state=0\n");
}

TEST(AnswerRequest, HighestLevelOfABundleCounts) {
  FaceFixture face;
  face.caller = {"guest", Privilege::kUser};
  const RoutedReply routed = face.Route("/rev.cgi?Cmd=GetCamera.cgi&Cmd=GetUser.cgi");
  EXPECT_EQ(routed.response.status, 401);
  EXPECT_EQ(routed.response.extra_headers,
            "WWW-Authenticate: Basic realm=\"Administrator for Rovio\"\r\n");
  face.caller = {};
  EXPECT_EQ(face.Route("/rev.cgi?Cmd=nonsense").response.extra_headers,
            "WWW-Authenticate: Basic realm=\"Rovio\"\r\n");
}

TEST(AnswerRequest, ShowsABrowserAPage) {
  FaceFixture face;
  const RoutedReply routed = face.Route("/");
  EXPECT_EQ(routed.response.status, 200);
  EXPECT_EQ(routed.response.content_type, "text/html");
  EXPECT_NE(routed.response.body.find("/GetData.cgi"), std::string::npos);
}

TEST(AnswerRequest, OptionsApplyToTheWholeReply) {
  FaceFixture face;
  EXPECT_EQ(face.Ask("/rev.cgi?Cmd=nav&action=22&JsVar=x"),
            "x=\"Cmd = nav\\nresponses = 0 | state=0\\n\";\n");
}

TEST(AnswerRequest, RedirectsAfterTheWorkAndKeepsHeadersClean) {
  FaceFixture face;
  const RoutedReply routed =
      face.Route("/rev.cgi?Cmd=nav&action=33&RedirectUrl=/a%0D%0AX-Evil:%201");
  EXPECT_EQ(routed.response.status, 302);
  EXPECT_EQ(routed.response.extra_headers, "Location: /aX-Evil: 1\r\n");
  EXPECT_EQ(face.robot.TakeLog(), "stop");
}

TEST(AnswerRequest, OtherMethodsAndPathsAreNotFound) {
  FaceFixture face;
  EXPECT_EQ(face.Route("/GetVer.cgi", "DELETE").response.status, 404);
  EXPECT_EQ(face.Status("/nowhere.html"), 404);
}

TEST(IsStillPath, TakesAnyTextBetween) {
  EXPECT_TRUE(IsStillPath("/Jpeg/CamImg.jpg"));
  EXPECT_TRUE(IsStillPath("/Jpeg/CamImg[0000].jpg"));
  EXPECT_FALSE(IsStillPath("/Jpeg/CamIm.jpg"));
  EXPECT_FALSE(IsStillPath("/Jpeg/CamImg1.png"));
  EXPECT_TRUE(IsStreamPath("/GetData.cgi"));
}

}  // namespace
}  // namespace rovio_sfm::sim
