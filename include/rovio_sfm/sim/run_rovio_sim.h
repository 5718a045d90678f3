#pragma once

namespace rovio_sfm::sim {

// The program rovio_sim: reads the command line and runs the mode it asks for. Returns the exit
// status. Throws std::exception for wrong files.
int RunRovioSim(int argc, const char* const* argv);

}  // namespace rovio_sfm::sim
