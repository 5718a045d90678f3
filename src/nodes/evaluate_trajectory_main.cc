#include <exception>
#include <iostream>

#include "rovio_sfm/tools/trajectory/evaluate_trajectory.h"

int main(int argc, char** argv) {
  try {
    return rovio_sfm::EvaluateTrajectoryCommand(argc, argv, std::cout);
  } catch (const std::exception& error) {
    std::cerr << "evaluate_trajectory: " << error.what() << "\n";
    return 1;
  }
}
