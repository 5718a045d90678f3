#include <exception>
#include <iostream>

#include "rovio_sfm/tools/calibrate_camera.h"

int main(int argc, char** argv) {
  try {
    return rovio_sfm::CalibrateCameraCommand(argc, argv, std::cout);
  } catch (const std::exception& error) {
    std::cerr << "calibrate_camera: " << error.what() << "\n";
    return 1;
  }
}
