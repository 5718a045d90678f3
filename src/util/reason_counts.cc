#include "rovio_sfm/util/reason_counts.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <utility>
#include <vector>

namespace rovio_sfm {
namespace {

constexpr size_t kMaxReasons = 50;
constexpr int kNumberWidth = 8;

}  // namespace

void CountReason(const std::string& reason, ReasonCounts* counts, uint64_t number) {
  const bool has_room = counts->size() < kMaxReasons || counts->count(reason) > 0;
  (*counts)[has_room ? reason : "other reasons"] += number;
}

void AddReasons(const ReasonCounts& more, ReasonCounts* counts) {
  for (const auto& [reason, number] : more) CountReason(reason, counts, number);
}

std::string ReasonTable(const ReasonCounts& counts) {
  std::vector<std::pair<std::string, uint64_t>> rows(counts.begin(), counts.end());
  std::stable_sort(rows.begin(), rows.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::ostringstream table;
  for (const auto& [reason, number] : rows) {
    table << std::setw(kNumberWidth) << number << "  " << reason << "\n";
  }
  return table.str();
}

}  // namespace rovio_sfm
