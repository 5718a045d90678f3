#pragma once

#include <cstdint>
#include <string>

#include "rovio_sfm/sim/robot/robot_backend.h"

namespace rovio_sfm::sim {

// The 30 upper-case hex digits of nav action 20: length byte 0x0E, then direction byte and
// big-endian ticks of left, right and rear wheel, head position, battery and status.
std::string FormatMcuReport(const McuReading& reading);

// Byte 14 of that report: bit 0 headlight, 1 IR, 2 obstacle, 3 charge complete, 4 charging, 5
// charger error, 6 on dock. `charging` of GetReport is this & 0x78.
uint8_t McuStatusByte(const McuReading& reading);

}  // namespace rovio_sfm::sim
