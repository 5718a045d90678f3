#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rovio_sfm::sim {

// The firmware's levels, with its numbers.
enum class Privilege : int { kAny = -1, kUser = 0, kAdmin = 1 };

// Who sent a request, as far as the robot believes it.
struct Caller {
  std::string name;
  Privilege privilege = Privilege::kAny;
};

struct Account {
  std::string name;
  std::string password;
  Privilege privilege = Privilege::kUser;
};

// The robot's users. Checking is off at first: then credentials are ignored and everybody is
// administrator; admin/admin exists all the same. The last administrator stays one. Not
// thread-safe.
class Accounts {
 public:
  Accounts();

  // The value of the request's Authorization header, empty without.
  Caller Authenticate(std::string_view authorization) const;

  // False, and nothing done, for names or passwords of 24 and more characters, an empty name, or a
  // 31st user.
  bool Set(const Account& account);
  void Delete(std::string_view name);

  bool is_checking() const { return is_checking_; }
  void set_checking(bool checking) { is_checking_ = checking; }
  const std::vector<Account>& accounts() const { return accounts_; }

 private:
  bool IsLastAdministrator(const Account& account) const;

  std::vector<Account> accounts_;
  bool is_checking_ = false;
};

// Nothing when the text is no Base64.
std::optional<std::string> DecodeBase64(std::string_view text);

}  // namespace rovio_sfm::sim
