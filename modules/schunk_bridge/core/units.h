#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scanway::schunk {

/// How a module counts (its setting 06). Floats are float32, integers int32, both little endian.
enum class UnitSystem : std::uint8_t {
  millimetre = 0,
  metre = 1,
  inch = 2,
  radian = 3,
  degree = 4,
  internal = 5,
  micrometre_int = 6,
  microdegree_int = 7,
  microinch_int = 8,
  millidegree_int = 9,
};

/// "deg"; empty for a number that is no unit system.
std::string_view name_of(UnitSystem units);
bool is_known(UnitSystem units);
bool is_integer(UnitSystem units);
/// Radians per unit of a rotary system; nothing for a linear one and for internal units.
std::optional<double> radians_per_unit(UnitSystem units);

/// A number on the wire, in the module's own unit. `bytes` holds 4.
double read_number(std::span<const std::uint8_t> bytes, UnitSystem units);
/// The nearest number that the wire can carry.
void append_number(std::vector<std::uint8_t>& bytes, double value, UnitSystem units);

/// Times count in seconds, in integer systems in milliseconds.
double read_seconds(std::span<const std::uint8_t> bytes, UnitSystem units);
void append_seconds(std::vector<std::uint8_t>& bytes, double seconds, UnitSystem units);
/// Currents count in amperes, in integer systems in milliamperes.
double read_amperes(std::span<const std::uint8_t> bytes, UnitSystem units);
void append_amperes(std::vector<std::uint8_t>& bytes, double amperes, UnitSystem units);

/// Little endian, 1 to 4 bytes.
std::uint32_t read_unsigned(std::span<const std::uint8_t> bytes);
void append_unsigned(std::vector<std::uint8_t>& bytes, std::uint32_t value, int count);
float read_float(std::span<const std::uint8_t> bytes);
void append_float(std::vector<std::uint8_t>& bytes, float value);

}  // namespace scanway::schunk
