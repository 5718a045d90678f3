#include "rovio_sfm/sim/http/accounts.h"

#include <gtest/gtest.h>

namespace rovio_sfm::sim {
namespace {

constexpr char kAdmin[] = "Basic YWRtaW46YWRtaW4=";  // admin:admin
constexpr char kWrong[] = "Basic YWRtaW46d3Jvbmc=";  // admin:wrong
constexpr char kGuest[] = "basic Z3Vlc3Q6c2VjcmV0";  // guest:secret

TEST(Accounts, WithoutCheckingEverybodyIsAdministrator) {
  const Accounts accounts;
  EXPECT_EQ(accounts.Authenticate("").privilege, Privilege::kAdmin);
  EXPECT_EQ(accounts.Authenticate(kWrong).privilege, Privilege::kAdmin);
  EXPECT_EQ(accounts.Authenticate(kAdmin).name, "");
}

TEST(Accounts, CheckingTellsTheLevels) {
  Accounts accounts;
  accounts.set_checking(true);
  EXPECT_TRUE(accounts.Set({"guest", "secret", Privilege::kUser}));
  EXPECT_EQ(accounts.Authenticate(kAdmin).privilege, Privilege::kAdmin);
  EXPECT_EQ(accounts.Authenticate(kAdmin).name, "admin");
  EXPECT_EQ(accounts.Authenticate(kGuest).privilege, Privilege::kUser);
  for (const char* refused : {kWrong, "", "Basic", "Basic ***", "Bearer YWRtaW46YWRtaW4="}) {
    EXPECT_EQ(accounts.Authenticate(refused).privilege, Privilege::kAny) << refused;
  }
}

TEST(Accounts, LastAdministratorStays) {
  Accounts accounts;
  accounts.Delete("admin");
  EXPECT_EQ(accounts.accounts().size(), 1u);
  EXPECT_TRUE(accounts.Set({"admin", "new", Privilege::kUser}));
  EXPECT_EQ(accounts.accounts()[0].privilege, Privilege::kAdmin);
  EXPECT_EQ(accounts.accounts()[0].password, "new");
  EXPECT_TRUE(accounts.Set({"other", "x", Privilege::kAdmin}));
  accounts.Delete("admin");
  EXPECT_EQ(accounts.accounts()[0].name, "other");
}

TEST(Accounts, LimitsNamesAndNumber) {
  Accounts accounts;
  EXPECT_FALSE(accounts.Set({std::string(24, 'n'), "x", Privilege::kUser}));
  EXPECT_FALSE(accounts.Set({"n", std::string(24, 'x'), Privilege::kUser}));
  EXPECT_FALSE(accounts.Set({"", "x", Privilege::kUser}));
  for (int i = 1; i < 30; ++i) EXPECT_TRUE(accounts.Set({std::to_string(i), "", Privilege::kUser}));
  EXPECT_FALSE(accounts.Set({"31st", "", Privilege::kUser}));
}

TEST(DecodeBase64, RoundTripsAndRefuses) {
  EXPECT_EQ(DecodeBase64("TWFu"), "Man");
  EXPECT_EQ(DecodeBase64("TWE="), "Ma");
  EXPECT_EQ(DecodeBase64(""), "");
  EXPECT_EQ(DecodeBase64("T W"), std::nullopt);
}

}  // namespace
}  // namespace rovio_sfm::sim
