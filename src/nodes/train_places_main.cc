#include <exception>
#include <iostream>

#include "rovio_sfm/tools/train_places.h"

int main(int argc, char** argv) {
  try {
    return rovio_sfm::TrainPlacesCommand(argc, argv, std::cout);
  } catch (const std::exception& error) {
    std::cerr << "train_places: " << error.what() << "\n";
    return 1;
  }
}
