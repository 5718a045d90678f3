#include <gtest/gtest.h>

#include "sim/http/face_fixture.h"

namespace rovio_sfm::sim {
namespace {

TEST(AccountCommands, AddShowAndDeleteUsers) {
  FaceFixture face;
  EXPECT_EQ(face.Ask("/SetUser.cgi?User=guest&Pass=secret"), "");
  EXPECT_EQ(face.Ask("/SetUser.cgi?User=boss&Pass=x&Privilege=1"), "");
  EXPECT_EQ(face.Ask("/GetUser.cgi"), "Name = admin\nName = guest\nName = boss\n");
  EXPECT_EQ(face.Ask("/GetUser.cgi?ShowPrivilege=true"),
            "Name = admin\nName = guest\nName = boss\n"
            "Privilege = 0\nPrivilege = 1\nPrivilege = 0\n");
  face.Ask("/DelUser.cgi?User=guest");
  EXPECT_EQ(face.Ask("/GetUser.cgi"), "Name = admin\nName = boss\n");
}

TEST(AccountCommands, SetUserCheckSwitchesChecking) {
  FaceFixture face;
  EXPECT_EQ(face.Ask("/SetUserCheck.cgi?Check=true"), "");
  EXPECT_TRUE(face.context.accounts.With([](Accounts& a) { return a.is_checking(); }));
}

TEST(AccountCommands, MyselfHasNoNameWithoutChecking) {
  FaceFixture face;
  EXPECT_EQ(face.Ask("/GetMyself.cgi?ShowPrivilege=true"), "Name = \nPrivilege = 1\n");
  face.caller = {"guest", Privilege::kUser};
  EXPECT_EQ(face.Ask("/GetMyself.cgi"), "Name = guest\n");
  EXPECT_EQ(face.Ask("/GetMyself.cgi?ShowPrivilege=1"), "Name = guest\nPrivilege = 0\n");
}

TEST(AccountCommands, GuestsMayChangeTheirOwnPasswordOnly) {
  FaceFixture face;
  face.Ask("/SetUser.cgi?User=guest&Pass=old");
  face.caller = {"guest", Privilege::kUser};
  EXPECT_EQ(face.Status("/SetUser.cgi?User=guest&Pass=new"), 200);
  EXPECT_EQ(face.Status("/SetUser.cgi?User=admin&Pass=new"), 401);
  EXPECT_EQ(face.Status("/GetUser.cgi"), 401);
  EXPECT_EQ(face.Status("/SetUserCheck.cgi?Check=false"), 401);
}

}  // namespace
}  // namespace rovio_sfm::sim
