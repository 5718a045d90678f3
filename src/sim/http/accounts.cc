#include "rovio_sfm/sim/http/accounts.h"

#include <strings.h>

#include <algorithm>
#include <cstdint>

namespace rovio_sfm::sim {
namespace {

constexpr size_t kMaxNameBytes = 23;
constexpr size_t kMaxAccounts = 30;

auto FindAccount(const std::vector<Account>& accounts, std::string_view name) {
  return std::find_if(accounts.begin(), accounts.end(),
                      [name](const Account& account) { return account.name == name; });
}

}  // namespace

std::optional<std::string> DecodeBase64(std::string_view text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::string decoded;
  uint32_t bits = 0;
  int num_bits = 0;
  for (const char c : text) {
    const size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    bits = (bits << 6 | static_cast<uint32_t>(digit)) & 0xFFFFu;
    num_bits += 6;
    if (num_bits < 8) continue;
    num_bits -= 8;
    decoded += static_cast<char>(bits >> num_bits & 0xFFu);
  }
  return decoded;
}

Accounts::Accounts() : accounts_{{"admin", "admin", Privilege::kAdmin}} {}

Caller Accounts::Authenticate(std::string_view authorization) const {
  if (!is_checking_) return {"", Privilege::kAdmin};
  constexpr std::string_view kScheme = "Basic ";
  if (authorization.size() < kScheme.size() ||
      strncasecmp(authorization.data(), kScheme.data(), kScheme.size()) != 0) {
    return {};
  }
  const auto pair = DecodeBase64(authorization.substr(kScheme.size()));
  if (!pair || pair->find(':') == std::string::npos) return {};
  const size_t colon = pair->find(':');
  const auto found = FindAccount(accounts_, pair->substr(0, colon));
  if (found == accounts_.end() || found->password != pair->substr(colon + 1)) return {};
  return {found->name, found->privilege};
}

bool Accounts::Set(const Account& account) {
  if (account.name.empty() || account.name.size() > kMaxNameBytes ||
      account.password.size() > kMaxNameBytes) {
    return false;
  }
  const auto found = FindAccount(accounts_, account.name);
  if (found == accounts_.end()) {
    if (accounts_.size() >= kMaxAccounts) return false;
    accounts_.push_back(account);
    return true;
  }
  Account changed = account;
  if (IsLastAdministrator(*found)) changed.privilege = Privilege::kAdmin;
  accounts_[static_cast<size_t>(found - accounts_.begin())] = changed;
  return true;
}

void Accounts::Delete(std::string_view name) {
  const auto found = FindAccount(accounts_, name);
  if (found == accounts_.end() || IsLastAdministrator(*found)) return;
  accounts_.erase(found);
}

bool Accounts::IsLastAdministrator(const Account& account) const {
  if (account.privilege != Privilege::kAdmin) return false;
  return std::count_if(accounts_.begin(), accounts_.end(), [](const Account& other) {
           return other.privilege == Privilege::kAdmin;
         }) == 1;
}

}  // namespace rovio_sfm::sim
