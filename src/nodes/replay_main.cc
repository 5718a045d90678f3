#include <exception>
#include <iostream>

#include "rovio_sfm/ros/replay.h"
#include "rovio_sfm/util/stop_signals.h"

int main(int argc, char** argv) {
  rovio_sfm::CatchStopSignals();
  try {
    return rovio_sfm::ReplayCommand(argc, argv, std::cout, std::cerr);
  } catch (const std::exception& error) {
    std::cerr << "replay: " << error.what() << "\n";
    return 1;
  }
}
