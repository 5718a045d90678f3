#include <exception>
#include <iostream>

#include "rovio_sfm/tools/map_images.h"
#include "rovio_sfm/util/stop_signals.h"

int main(int argc, char** argv) {
  rovio_sfm::CatchStopSignals();
  try {
    return rovio_sfm::MapImagesCommand(argc, argv, std::cout);
  } catch (const std::exception& error) {
    std::cerr << "map_images: " << error.what() << "\n";
    return 1;
  }
}
