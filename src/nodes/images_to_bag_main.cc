#include <exception>
#include <iostream>

#include "rovio_sfm/ros/images_to_bag.h"
#include "rovio_sfm/util/stop_signals.h"

int main(int argc, char** argv) {
  rovio_sfm::CatchStopSignals();
  try {
    return rovio_sfm::ImagesToBagCommand(argc, argv, std::cout);
  } catch (const std::exception& error) {
    std::cerr << "images_to_bag: " << error.what() << "\n";
    return 1;
  }
}
