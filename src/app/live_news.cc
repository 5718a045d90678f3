#include "rovio_sfm/app/live_news.h"

#include <utility>

#include "rovio_sfm/util/count_text.h"

namespace rovio_sfm {
namespace {

std::string NameOf(const SessionSnapshot& session) {
  return "session " + std::to_string(session.id.value) + " of " + session.drive.robot;
}

size_t CountFrames(const SessionSnapshot& session) {
  size_t count = 0;
  for (const auto& block : session.frames) count += block->size();
  return count;
}

}  // namespace

std::vector<std::string> LiveNews::Since(const MapPicture& picture) {
  if (picture.epoch == epoch_) return Take(picture);
  states_.clear();
  verdicts_.clear();
  Take(picture);
  return {};
}

std::vector<std::string> LiveNews::Take(const MapPicture& picture) {
  epoch_ = picture.epoch;
  std::vector<std::string> news;
  const auto add = [&](std::string sentence) {
    if (!sentence.empty()) news.push_back(std::move(sentence));
  };
  for (const SessionSnapshot& session : picture.snapshot->sessions) {
    if (!session.frames.empty()) add(NewsOf(session));
  }
  for (const MergeReport& report : *picture.merges) add(NewsOf(report));
  return news;
}

std::string LiveNews::NewsOf(const SessionSnapshot& session) {
  const auto [known, is_new] = states_.emplace(session.id, session.state);
  const SessionState before = std::exchange(known->second, session.state);
  if (session.state == SessionState::kLost && (is_new || before != SessionState::kLost)) {
    return NameOf(session) + " is lost after " + CountText(CountFrames(session), "frame");
  }
  return is_new ? NameOf(session) + " begins" : "";
}

// Loops join nothing; what is refused or waits is told by map_status.
std::string LiveNews::NewsOf(const MergeReport& report) {
  const auto [known, is_new] = verdicts_.emplace(report.id, MergeVerdict::kWaiting);
  const MergeVerdict before = std::exchange(known->second, report.verdict);
  if (report.verdict == before || report.kind == MergeKind::kLoop) return "";
  const std::string sessions = "sessions " + std::to_string(report.other_session.value) + " and " +
                               std::to_string(report.query_session.value);
  switch (report.verdict) {
    case MergeVerdict::kAccepted:
      return sessions + " are joined: " + report.reason;
    case MergeVerdict::kProvisional:
      return sessions + " may be joined: " + report.reason;
    case MergeVerdict::kUndone:
      return sessions + " are parted again: " + report.reason;
    case MergeVerdict::kWaiting:
    case MergeVerdict::kRefused:
      break;
  }
  return "";
}

}  // namespace rovio_sfm
