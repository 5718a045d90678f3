#include "rovio_sfm/merging/waiting_matches.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

WaitingMatch Match(uint32_t query, uint32_t other) {
  WaitingMatch entry;
  entry.match.query = {{"second", 2, 0}, query};
  entry.match.pairs.resize(1);
  entry.match.pairs[0].other = {{"first", 1, 0}, other};
  return entry;
}

TEST(WaitingMatches, TriesEachInOrderUntilItIsSettled) {
  WaitingMatches waiting;
  std::vector<uint32_t> tried, given_up;
  const auto give_up = [&](const WaitingMatch& e) { given_up.push_back(e.match.query.index); };
  for (const uint32_t query : {1u, 2u, 3u}) waiting.Add(Match(query, 0), give_up);
  const auto settle_two = [&](WaitingMatch* entry) {
    tried.push_back(entry->match.query.index);
    return entry->match.query.index == 2;
  };
  waiting.Advance(1, settle_two, give_up);
  EXPECT_EQ(tried, (std::vector<uint32_t>{1, 2, 3}));
  EXPECT_EQ(waiting.size(), 2u);
  EXPECT_TRUE(given_up.empty());
  waiting.Advance(1, settle_two, give_up);
  EXPECT_EQ(given_up, (std::vector<uint32_t>{1, 3})) << "older than one keyframe";
  EXPECT_EQ(waiting.size(), 0u);
}

TEST(WaitingMatches, KnowsItsFramesWhicheverAsked) {
  WaitingMatches waiting;
  const WaitingMatch entry = Match(4, 7);
  waiting.Add(entry, [](const WaitingMatch&) {});
  EXPECT_TRUE(waiting.HoldsBoth(entry.match.query, entry.match.pairs[0].other));
  EXPECT_TRUE(waiting.HoldsBoth(entry.match.pairs[0].other, entry.match.query));
  EXPECT_FALSE(waiting.HoldsBoth(entry.match.query, entry.match.query));
  EXPECT_EQ(waiting.OfDrive(entry.match.query.drive).size(), 1u);
  EXPECT_TRUE(waiting.OfDrive(entry.match.pairs[0].other.drive).empty());
}

TEST(WaitingMatches, TheOldestGivesUpWhereTheyAreTooMany) {
  WaitingMatches waiting;
  std::vector<uint32_t> given_up;
  const auto give_up = [&](const WaitingMatch& e) { given_up.push_back(e.match.query.index); };
  for (uint32_t i = 0; i <= WaitingMatches::kCapacity; ++i) waiting.Add(Match(i, 0), give_up);
  EXPECT_EQ(waiting.size(), WaitingMatches::kCapacity);
  EXPECT_EQ(given_up, std::vector<uint32_t>{0});
  waiting.Clear(give_up);
  EXPECT_EQ(waiting.size(), 0u);
  EXPECT_EQ(given_up.size(), WaitingMatches::kCapacity + 1);
}

}  // namespace
}  // namespace rovio_sfm
