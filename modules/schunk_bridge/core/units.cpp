#include "modules/schunk_bridge/core/units.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "common/math/angle.h"

namespace scanway::schunk {
namespace {

std::int32_t to_int32(double value) {
  constexpr double lowest = std::numeric_limits<std::int32_t>::min(),
                   highest = std::numeric_limits<std::int32_t>::max();
  if (!(value > lowest)) return std::numeric_limits<std::int32_t>::min();
  return static_cast<std::int32_t>(std::floor(std::min(value, highest - 0.5) + 0.5));
}

double thousandth_if_integer(UnitSystem units) { return is_integer(units) ? 1000.0 : 1.0; }

}  // namespace

std::string_view name_of(UnitSystem units) {
  switch (units) {
    case UnitSystem::millimetre:
      return "mm";
    case UnitSystem::metre:
      return "m";
    case UnitSystem::inch:
      return "inch";
    case UnitSystem::radian:
      return "rad";
    case UnitSystem::degree:
      return "deg";
    case UnitSystem::internal:
      return "internal";
    case UnitSystem::micrometre_int:
      return "um int";
    case UnitSystem::microdegree_int:
      return "udeg int";
    case UnitSystem::microinch_int:
      return "uinch int";
    case UnitSystem::millidegree_int:
      return "mdeg int";
  }
  return {};
}

bool is_known(UnitSystem units) { return !name_of(units).empty(); }

bool is_integer(UnitSystem units) { return units >= UnitSystem::micrometre_int && is_known(units); }

std::optional<double> radians_per_unit(UnitSystem units) {
  switch (units) {
    case UnitSystem::radian:
      return 1.0;
    case UnitSystem::degree:
      return radians(1.0L);
    case UnitSystem::microdegree_int:
      return radians(1e-6L);
    case UnitSystem::millidegree_int:
      return radians(1e-3L);
    default:
      return std::nullopt;
  }
}

double read_number(std::span<const std::uint8_t> bytes, UnitSystem units) {
  if (is_integer(units)) return static_cast<std::int32_t>(read_unsigned(bytes.first(4)));
  return static_cast<double>(read_float(bytes));
}

void append_number(std::vector<std::uint8_t>& bytes, double value, UnitSystem units) {
  if (is_integer(units)) {
    append_unsigned(bytes, static_cast<std::uint32_t>(to_int32(value)), 4);
  } else {
    append_float(bytes, static_cast<float>(value));
  }
}

double read_seconds(std::span<const std::uint8_t> bytes, UnitSystem units) {
  return read_number(bytes, units) / thousandth_if_integer(units);
}

void append_seconds(std::vector<std::uint8_t>& bytes, double seconds, UnitSystem units) {
  append_number(bytes, seconds * thousandth_if_integer(units), units);
}

double read_amperes(std::span<const std::uint8_t> bytes, UnitSystem units) {
  return read_number(bytes, units) / thousandth_if_integer(units);
}

void append_amperes(std::vector<std::uint8_t>& bytes, double amperes, UnitSystem units) {
  append_number(bytes, amperes * thousandth_if_integer(units), units);
}

std::uint32_t read_unsigned(std::span<const std::uint8_t> bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < bytes.size() && i < 4; ++i) value |= std::uint32_t{bytes[i]} << (8 * i);
  return value;
}

void append_unsigned(std::vector<std::uint8_t>& bytes, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

float read_float(std::span<const std::uint8_t> bytes) { return std::bit_cast<float>(read_unsigned(bytes.first(4))); }

void append_float(std::vector<std::uint8_t>& bytes, float value) {
  append_unsigned(bytes, std::bit_cast<std::uint32_t>(value), 4);
}

}  // namespace scanway::schunk
