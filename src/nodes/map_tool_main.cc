#include <exception>
#include <iostream>

#include "rovio_sfm/tools/map_tool.h"

int main(int argc, char** argv) {
  try {
    return rovio_sfm::MapToolCommand(argc, argv, std::cout);
  } catch (const std::exception& error) {
    std::cerr << "map_tool: " << error.what() << "\n";
    return 1;
  }
}
