#include "rovio_sfm/util/stop_signals.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <ctime>

namespace rovio_sfm {
namespace {

constexpr int64_t kSameWishNs = 500000000;
constexpr int kSignalStatus = 128;

// A signal handler may touch nothing but lock-free atomics; signals are the process's, so is this.
std::atomic<int> first_signal{0}, late_signal{0}, num_late{0};
std::atomic<int64_t> first_ns{0};
std::atomic<bool> is_held{false};

int64_t SteadyNsOfSignal() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<int64_t>(now.tv_sec) * 1000000000 + now.tv_nsec;
}

void OnStop(int signal) {
  const int64_t now_ns = SteadyNsOfSignal();
  int none = 0;
  if (first_signal.compare_exchange_strong(none, signal)) {
    first_ns = now_ns;
    return;
  }
  if (now_ns - first_ns < kSameWishNs) return;
  late_signal = signal;
  if (++num_late > 1 || !is_held) ::_exit(kSignalStatus + signal);
}

}  // namespace

void CatchStopSignals() {
  struct sigaction action = {};
  action.sa_handler = OnStop;
  sigfillset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
  struct sigaction before = {};
  ::sigaction(SIGHUP, nullptr, &before);  // a closed terminal, but not under nohup
  if (before.sa_handler != SIG_IGN) ::sigaction(SIGHUP, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of writing it
}

bool IsStopRequested() { return first_signal != 0; }

std::optional<double> SecondsSinceStop() {
  if (first_signal == 0) return std::nullopt;
  return 1e-9 * static_cast<double>(SteadyNsOfSignal() - first_ns);
}

int StatusOfStop() { return kSignalStatus + first_signal; }

HoldSecondStop::HoldSecondStop() { is_held = true; }

HoldSecondStop::~HoldSecondStop() {
  is_held = false;
  if (num_late > 0) ::_exit(kSignalStatus + late_signal);
}

}  // namespace rovio_sfm
