#include <exception>
#include <iostream>

#include "rovio_sfm/tools/train_places.h"
#include "rovio_sfm/util/stop_signals.h"

int main(int argc, char** argv) {
  rovio_sfm::CatchStopSignals();
  try {
    return rovio_sfm::TrainPlacesCommand(argc, argv, std::cout);
  } catch (const std::exception& error) {
    std::cerr << "train_places: " << error.what() << "\n";
    return 1;
  }
}
