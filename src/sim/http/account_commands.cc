#include "rovio_sfm/sim/http/command.h"

namespace rovio_sfm::sim {
namespace {

// Everybody may change the own password.
Privilege SetUserLevel(const CommandCall& call) {
  const bool self = !call.caller.name.empty() && call.parameters.Get("User") == call.caller.name;
  return self ? Privilege::kUser : Privilege::kAdmin;
}

Privilege PrivilegeOf(const Accounts& accounts, const std::string& name) {
  for (const Account& account : accounts.accounts()) {
    if (account.name == name) return account.privilege;
  }
  return Privilege::kUser;
}

// Privilege=1 makes an administrator, 0 a guest; without it a known user keeps the level. (The
// firmware lets a guest raise the own level that way; so does this.)
void SetUser(const CommandCall& call, CommandReply*) {
  if (!call.parameters.Has("User") || !call.parameters.Has("Pass")) return;
  Account account{call.parameters.Get("User"), call.parameters.Get("Pass"), Privilege::kUser};
  call.context.accounts.With([&](Accounts& accounts) {
    const auto level = call.parameters.GetLong("Privilege");
    account.privilege = PrivilegeOf(accounts, account.name);
    if (level) account.privilege = *level >= 1 ? Privilege::kAdmin : Privilege::kUser;
    accounts.Set(account);
  });
}

void DelUser(const CommandCall& call, CommandReply*) {
  const std::string name = call.parameters.Get("User");
  call.context.accounts.With([&](Accounts& accounts) { accounts.Delete(name); });
}

// Here 0 means administrator.
void GetUser(const CommandCall& call, CommandReply* reply) {
  const bool show_privilege = call.parameters.GetBool("ShowPrivilege");
  call.context.accounts.With([&](Accounts& accounts) {
    for (const Account& account : accounts.accounts()) {
      reply->fields.Add("Name", account.name);
      if (!show_privilege) continue;
      reply->fields.Add("Privilege", account.privilege == Privilege::kAdmin ? "0" : "1");
    }
  });
}

void SetUserCheck(const CommandCall& call, CommandReply*) {
  const bool check = call.parameters.GetBool("Check");
  call.context.accounts.With([&](Accounts& accounts) { accounts.set_checking(check); });
}

// Here 1 means administrator.
void GetMyself(const CommandCall& call, CommandReply* reply) {
  reply->fields.Add("Name", call.caller.name);
  if (!call.parameters.GetBool("ShowPrivilege")) return;
  reply->fields.Add("Privilege", call.caller.privilege == Privilege::kAdmin ? "1" : "0");
}

}  // namespace

std::vector<Command> AccountCommands() {
  return {{"SetUser.cgi", SetUserLevel, SetUser},
          {"DelUser.cgi", SetUserLevel, DelUser},
          {"GetUser.cgi", NeedsAdmin, GetUser},
          {"SetUserCheck.cgi", NeedsAdmin, SetUserCheck},
          {"GetMyself.cgi", NeedsUser, GetMyself}};
}

}  // namespace rovio_sfm::sim
