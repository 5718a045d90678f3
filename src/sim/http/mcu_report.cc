#include "rovio_sfm/sim/http/mcu_report.h"

#include <array>

namespace rovio_sfm::sim {
namespace {

uint8_t HighByte(uint16_t value) { return static_cast<uint8_t>(value >> 8); }
uint8_t LowByte(uint16_t value) { return static_cast<uint8_t>(value & 0xFF); }

}  // namespace

uint8_t McuStatusByte(const McuReading& reading) {
  const std::array<bool, 7> bits = {
      reading.headlight, reading.infrared,      reading.obstacle, reading.charge_complete,
      reading.charging,  reading.charger_error, reading.on_dock};
  int status = 0;
  for (size_t i = 0; i < bits.size(); ++i) status |= bits[i] ? 1 << i : 0;
  return static_cast<uint8_t>(status);
}

std::string FormatMcuReport(const McuReading& reading) {
  const WheelReading& left = reading.left;
  const WheelReading& right = reading.right;
  const WheelReading& rear = reading.rear;
  const std::array<uint8_t, 15> bytes = {0x0E,
                                         0x01,
                                         left.direction,
                                         HighByte(left.ticks),
                                         LowByte(left.ticks),
                                         right.direction,
                                         HighByte(right.ticks),
                                         LowByte(right.ticks),
                                         rear.direction,
                                         HighByte(rear.ticks),
                                         LowByte(rear.ticks),
                                         0x03,
                                         reading.head_position,
                                         reading.battery,
                                         McuStatusByte(reading)};
  constexpr char kDigits[] = "0123456789ABCDEF";
  std::string text;
  for (const uint8_t byte : bytes) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 0xF];
  }
  return text;
}

}  // namespace rovio_sfm::sim
