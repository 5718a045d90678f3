#include "rovio_sfm/util/option_checker.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rovio_sfm {
namespace {

struct Inner {
  int size = 0;
  bool IsValid(std::string* error) const {
    OptionChecker checker("inner", error);
    checker.Range("size", size, 1, 9);
    return checker.Passed();
  }
};

TEST(OptionChecker, ReportsTheFirstComplaint) {
  std::string error;
  OptionChecker checker("group", &error);
  checker.Range("fine", 3, 1, 5);
  checker.Range("small", 0, 1, 5);
  checker.True("odd", false, "an odd number");
  EXPECT_FALSE(checker.Passed());
  EXPECT_EQ(error, "group.small = 0: expected 1 to 5");
}

TEST(OptionChecker, TakesOverANestedComplaint) {
  std::string error;
  OptionChecker checker("outer", &error);
  checker.Nested(Inner{});
  EXPECT_FALSE(checker.Passed());
  EXPECT_EQ(error, "inner.size = 0: expected 1 to 9");
}

TEST(OptionChecker, RefusesNanAndLivesWithoutAnErrorString) {
  OptionChecker checker("group", nullptr);
  checker.Range("value", std::nan(""), 0.0, 1.0);
  EXPECT_FALSE(checker.Passed());
}

}  // namespace
}  // namespace rovio_sfm
