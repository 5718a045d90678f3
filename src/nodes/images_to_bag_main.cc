#include <exception>
#include <iostream>

#include "rovio_sfm/ros/images_to_bag.h"

int main(int argc, char** argv) {
  try {
    return rovio_sfm::ImagesToBagCommand(argc, argv, std::cout);
  } catch (const std::exception& error) {
    std::cerr << "images_to_bag: " << error.what() << "\n";
    return 1;
  }
}
