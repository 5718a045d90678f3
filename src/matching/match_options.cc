#include "rovio_sfm/matching/match_options.h"

#include "rovio_sfm/util/option_checker.h"

namespace rovio_sfm {

bool MatchOptions::IsValid(std::string* error) const {
  OptionChecker checker("match", error);
  checker.Range("trees", trees, 1, 16);
  checker.Range("branching", branching, 2, 256);
  checker.Range("checks", checks, 1, 10000);
  return checker.Passed();
}

}  // namespace rovio_sfm
