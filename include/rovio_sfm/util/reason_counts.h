#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace rovio_sfm {

// Why things were left out, and how often: by reason, for people.
using ReasonCounts = std::map<std::string, uint64_t>;

// Counts a reason; those beyond the first 50 are counted together.
void CountReason(const std::string& reason, ReasonCounts* counts, uint64_t number = 1);

void AddReasons(const ReasonCounts& more, ReasonCounts* counts);

// A line for each, the most frequent first; empty without any.
std::string ReasonTable(const ReasonCounts& counts);

}  // namespace rovio_sfm
