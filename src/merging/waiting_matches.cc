#include "rovio_sfm/merging/waiting_matches.h"

#include <algorithm>
#include <utility>

namespace rovio_sfm {

void WaitingMatches::Add(WaitingMatch entry, const GiveUp& give_up) {
  entries_.push_back(std::move(entry));
  if (entries_.size() <= kCapacity) return;
  give_up(entries_.front());
  entries_.pop_front();
}

void WaitingMatches::Advance(int patience, const Try& try_now, const GiveUp& give_up) {
  for (WaitingMatch& entry : std::exchange(entries_, {})) {
    if (try_now(&entry)) continue;
    if (++entry.age > patience) {
      give_up(entry);
    } else {
      entries_.push_back(std::move(entry));
    }
  }
}

void WaitingMatches::Clear(const GiveUp& give_up) {
  for (const WaitingMatch& entry : std::exchange(entries_, {})) give_up(entry);
}

bool WaitingMatches::HoldsBoth(const FrameId& a, const FrameId& b) const {
  for (const WaitingMatch& entry : entries_) {
    for (const OverlapPair& pair : entry.match.pairs) {
      if (std::minmax(entry.match.query, pair.other) == std::minmax(a, b)) return true;
    }
  }
  return false;
}

std::vector<PlaceMatch> WaitingMatches::All() const {
  std::vector<PlaceMatch> matches;
  for (const WaitingMatch& entry : entries_) matches.push_back(entry.match);
  return matches;
}

std::vector<PlaceMatch> WaitingMatches::OfDrive(const DriveId& drive) const {
  std::vector<PlaceMatch> matches;
  for (const WaitingMatch& entry : entries_) {
    if (entry.match.query.drive == drive) matches.push_back(entry.match);
  }
  return matches;
}

}  // namespace rovio_sfm
