#include <exception>
#include <iostream>

#include "rovio_sfm/tools/measure_noise.h"

int main(int argc, char** argv) {
  try {
    return rovio_sfm::MeasureNoiseCommand(argc, argv, std::cout);
  } catch (const std::exception& error) {
    std::cerr << "measure_noise: " << error.what() << "\n";
    return 1;
  }
}
