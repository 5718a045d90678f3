#pragma once

#include <optional>

namespace rovio_sfm {

// From now on the first SIGINT, SIGTERM or, but under nohup, SIGHUP asks the program to end, and
// the second ends it at once with the exit status 128 + signal; a limit of file sizes is no signal
// but an error of writing. What comes within half a second of the first is the same wish:
// timeout(1) and terminals send a signal more than once. A third one spares nothing.
void CatchStopSignals();

bool IsStopRequested();
// Seconds of the steady clock since the first signal; nothing where none came.
std::optional<double> SecondsSinceStop();
// What a command that was stopped ends with: 128 + the first signal.
int StatusOfStop();

// While one lives the second signal waits: what is being saved is saved wholly. Not to be nested.
class HoldSecondStop {
 public:
  HoldSecondStop();
  ~HoldSecondStop();
  HoldSecondStop(const HoldSecondStop&) = delete;
  HoldSecondStop& operator=(const HoldSecondStop&) = delete;
};

}  // namespace rovio_sfm
