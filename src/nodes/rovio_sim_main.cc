#include <exception>
#include <iostream>

#include "rovio_sfm/sim/run_rovio_sim.h"

int main(int argc, char** argv) {
  try {
    return rovio_sfm::sim::RunRovioSim(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "rovio_sim: " << error.what() << std::endl;
    return 1;
  }
}
