#include <exception>
#include <iostream>

#include "rovio_sfm/ros/replay.h"

int main(int argc, char** argv) {
  try {
    return rovio_sfm::ReplayCommand(argc, argv, std::cout, std::cerr);
  } catch (const std::exception& error) {
    std::cerr << "replay: " << error.what() << "\n";
    return 1;
  }
}
