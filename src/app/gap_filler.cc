#include "rovio_sfm/app/gap_filler.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "rovio_sfm/util/log.h"

namespace rovio_sfm {

void GapFiller::Add(ArrivedFrame frame, double now_s) {
  const std::string robot = frame.id.drive.robot;
  const auto wait = waits_.find(robot);
  if (wait != waits_.end()) {
    wait->second.num_held_bytes += frame.num_bytes;
    wait->second.held.push_back(std::move(frame));
    const bool has_room = wait->second.held.size() <= options_.max_held &&
                          wait->second.num_held_bytes <= options_.max_held_bytes;
    if (has_room) return;
    const std::string count = std::to_string(wait->second.held.size() - 1);
    return GiveUp(robot, "before " + count + " more came", now_s);
  }
  const uint32_t next = next_index_(frame.id);
  if (next >= frame.id.index) return frame.deliver();
  if (IsSilent(robot)) {
    ++num_given_up_;
    return frame.deliver();
  }
  const GapFetch fetch = {++last_ticket_, {frame.id.drive, next}, frame.id.index};
  Wait& begun = waits_[robot];
  begun.fetch = fetch;
  begun.deadline_s = now_s + options_.timeout_s;
  begun.num_held_bytes = frame.num_bytes;
  begun.held.push_back(std::move(frame));
  begin_fetch_(fetch);
}

void GapFiller::TakeAnswer(uint64_t ticket, const std::vector<ArrivedFrame>& found, double now_s) {
  if (unanswered_.erase(ticket) > 0) {
    ++num_late_answers_;
    return;
  }
  const auto wait = std::find_if(waits_.begin(), waits_.end(), [&](const auto& entry) {
    return entry.second.fetch.ticket == ticket;
  });
  if (wait == waits_.end()) return;
  for (const ArrivedFrame& frame : found) frame.deliver();
  Release(std::string(wait->first), now_s);
}

void GapFiller::CheckTime(double now_s) {
  std::vector<std::string> late;
  for (const auto& [robot, wait] : waits_) {
    if (now_s >= wait.deadline_s) late.push_back(robot);
  }
  for (const std::string& robot : late) {
    std::ostringstream limit;
    limit << "within " << options_.timeout_s << " s";
    GiveUp(robot, limit.str(), now_s);
  }
}

void GapFiller::EndWait(const std::string& robot, double now_s) {
  if (waits_.count(robot) > 0) GiveUp(robot, "before the wait was ended", now_s);
}

void GapFiller::EndAllWaits(double now_s) {
  while (!waits_.empty()) EndWait(std::string(waits_.begin()->first), now_s);
}

size_t GapFiller::NumHeld() const {
  size_t count = 0;
  for (const auto& [robot, wait] : waits_) count += wait.held.size();
  return count;
}

bool GapFiller::IsSilent(const std::string& robot) const {
  return std::any_of(unanswered_.begin(), unanswered_.end(),
                     [&](const auto& entry) { return entry.second == robot; });
}

void GapFiller::GiveUp(const std::string& robot, const std::string& reason, double now_s) {
  const GapFetch& fetch = waits_.at(robot).fetch;
  LogWarning("frames " + std::to_string(fetch.first.index) + " to " +
             std::to_string(fetch.end - 1) + " of " + robot +
             " are taken as lost: get_frames did not answer " + reason);
  ++num_given_up_;
  unanswered_[fetch.ticket] = robot;
  Release(robot, now_s);
}

// The frame after the gap goes on, whatever is still missing; later ones may have gaps of their
// own.
void GapFiller::Release(const std::string& robot, double now_s) {
  std::deque<ArrivedFrame> held = std::move(waits_.at(robot).held);
  waits_.erase(robot);
  held.front().deliver();
  held.pop_front();
  for (ArrivedFrame& frame : held) Add(std::move(frame), now_s);
}

}  // namespace rovio_sfm
