#include "rovio_sfm/sim/serve.h"

#include <chrono>
#include <csignal>
#include <iostream>
#include <memory>

#include "rovio_sfm/sim/http/parameters.h"
#include "rovio_sfm/sim/robot/image_folder_backend.h"

namespace rovio_sfm::sim {
namespace {

// Holds SIGINT and SIGTERM back from all threads begun after it, so that one may wait for them.
class EndSignals {
 public:
  EndSignals() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals_, &mask_before_);
  }
  ~EndSignals() { pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr); }

  void Wait() const {
    int signal = 0;
    sigwait(&signals_, &signal);
  }

 private:
  sigset_t signals_, mask_before_;
};

bool SwitchQuirks(const std::vector<std::string>& quirks, RovioHttpServer& server,
                  std::string* error) {
  for (const std::string& quirk : quirks) {
    const size_t equals = quirk.find('=');
    const auto value =
        equals == std::string::npos ? std::nullopt : ParseDouble(quirk.substr(equals + 1));
    if (!value) {
      *error = "--quirk wants NAME=VALUE, not " + quirk;
      return false;
    }
    if (!server.SetQuirk(quirk.substr(0, equals), *value, error)) return false;
  }
  return true;
}

int ReportError(const std::string& error) {
  std::cerr << "rovio_sim: " << error << std::endl;
  return 1;
}

}  // namespace

Clock RealTimeClock() {
  using std::chrono::duration_cast;
  using std::chrono::nanoseconds;
  const auto unix_start = std::chrono::system_clock::now().time_since_epoch();
  const auto steady_start = std::chrono::steady_clock::now();
  return [unix_start, steady_start] {
    const auto elapsed = std::chrono::steady_clock::now() - steady_start;
    return duration_cast<nanoseconds>(unix_start + elapsed).count();
  };
}

int ServeRobot(const ServeOptions& options, RobotBackend& robot) {
  const EndSignals end_signals;
  RovioHttpServer server(options.server, robot, RealTimeClock());
  std::string error;
  if (!server.Start(&error)) return ReportError(error);
  if (!SwitchQuirks(options.quirks, server, &error)) return ReportError(error);
  server.StartCapturing();
  std::cout << "rovio_sim: http://" << options.server.socket.address << ":" << server.port() << "/"
            << std::endl;
  end_signals.Wait();
  server.Stop();
  return 0;
}

int ServeImages(const ServeOptions& options, const std::string& folder, bool repeats) {
  std::string error;
  const auto robot = ImageFolderBackend::Open(folder, repeats, &error);
  if (robot == nullptr) return ReportError(error);
  return ServeRobot(options, *robot);
}

}  // namespace rovio_sfm::sim
