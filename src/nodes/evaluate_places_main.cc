#include <exception>
#include <iostream>

#include "rovio_sfm/tools/evaluate_places.h"

int main(int argc, char** argv) {
  try {
    return rovio_sfm::EvaluatePlacesCommand(argc, argv, std::cout);
  } catch (const std::exception& error) {
    std::cerr << "evaluate_places: " << error.what() << "\n";
    return 1;
  }
}
