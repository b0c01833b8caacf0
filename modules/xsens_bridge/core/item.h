#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "common/bytes/big_endian.h"

namespace scanway::xsens {

/// How a device writes real numbers.
enum class NumberFormat : std::uint8_t { float32 = 0, fp12_20 = 1, fp16_32 = 2, float64 = 3 };

/// Bytes of one number.
std::size_t size_of(NumberFormat format);
double read_number(BigEndianReader& reader, NumberFormat format);
/// "float32", "fp12.20", "fp16.32", "float64".
const char* name_of(NumberFormat format);

/// The frame that an orientation or a velocity is given in: x east, y north, z up; x north, y east, z down; x north,
/// y west, z up.
enum class EarthFrame : std::uint8_t { enu, ned, nwu };

/// "ENU", "NED", "NWU".
const char* name_of(EarthFrame frame);

/// The device's calendar.
struct UtcTime {
  std::uint32_t nanosecond = 0;
  std::uint16_t year = 0;
  std::uint8_t month = 0, day = 0, hour = 0, minute = 0, second = 0;
  std::uint8_t flags = 0;  ///< Bit 0: the date is valid, 1: the time of day is, 2: it is fully resolved.
};

/// The twelve bytes of it.
UtcTime read_utc(BigEndianReader& reader);

struct BitField {
  std::uint32_t bits = 0;
  int digits = 8;  ///< Hexadecimal digits that it is written with.
};

using Numbers = std::vector<double>;
using Bytes = std::vector<std::uint8_t>;

/// Data of MTData2 by what they are: their identifier without the bits for frame and number format.
enum class Quantity : std::uint16_t {
  temperature = 0x0810,
  utc_time = 0x1010,
  packet_counter = 0x1020,
  sample_time_fine = 0x1060,
  sample_time_coarse = 0x1070,
  quaternion = 0x2010,
  rotation_matrix = 0x2020,
  euler = 0x2030,
  pressure = 0x3010,
  delta_v = 0x4010,
  acceleration = 0x4020,
  free_acceleration = 0x4030,
  acceleration_high_rate = 0x4040,
  altitude = 0x5020,
  position_ecef = 0x5030,
  lat_lon = 0x5040,
  gnss_pvt = 0x7010,
  gnss_satellites = 0x7020,
  rate_of_turn = 0x8020,
  delta_q = 0x8030,
  rate_of_turn_high_rate = 0x8040,
  magnetic_field = 0xC020,
  velocity = 0xD010,
  status_byte = 0xE010,
  status_word = 0xE020,
  device_id = 0xE080,
  location_id = 0xE090,
  // Of MTData alone; these are not on the wire.
  sample_counter = 1,
  raw_sensors = 2,
  raw_temperature = 3,
  analog_inputs = 4,
  position_lla = 5,
};

/// One piece of data of a message.
struct Item {
  std::uint16_t id = 0;   ///< As on the wire; 0 in MTData, which has none.
  Quantity quantity{};    ///< Only if `name` is not "unknown".
  std::string_view name;  ///< With its unit where that is not SI. Never owns: it lives as long as the program.
  NumberFormat format = NumberFormat::float32;  ///< If the value is Numbers.
  EarthFrame frame = EarthFrame::enu;           ///< If the quantity is an orientation or a velocity.
  /// Rotation matrices are row by row here, whatever the wire's order.
  std::variant<Numbers, std::uint32_t, BitField, UtcTime, Bytes> value;
};

/// Whether items of this quantity are given in an EarthFrame.
bool has_frame(Quantity quantity);

/// The item of that quantity, or nullptr.
const Item* find_item(std::span<const Item> items, Quantity quantity);

}  // namespace scanway::xsens
