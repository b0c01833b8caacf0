#include "common/config/units.h"

#include <array>
#include <charconv>
#include <cmath>

namespace scanway {
namespace {

constexpr long double kPi = 3.14159265358979323846264338327950288L;

// Longer endings before the shorter ones that they end in. Units that no key has are here for the sake of messages.
constexpr std::array kUnits = {
    Unit{"_m_s2", "metres a second squared", 1, 1},
    Unit{"_deg_s2", "degrees a second squared", kPi, 180},
    Unit{"_m_s", "metres a second", 1, 1},
    Unit{"_cm_s", "centimetres a second", 1, 100},
    Unit{"_mm_s", "millimetres a second", 1, 1000},
    Unit{"_km_h", "kilometres an hour", 10, 36},
    Unit{"_deg_s", "degrees a second", kPi, 180},
    Unit{"_rad_s", "radians a second", 1, 1},
    Unit{"_deg", "degrees", kPi, 180},
    Unit{"_mrad", "milliradians", 1, 1000},
    Unit{"_rad", "radians", 1, 1},
    Unit{"_m", "metres", 1, 1},
    Unit{"_cm", "centimetres", 1, 100},
    Unit{"_mm", "millimetres", 1, 1000},
    Unit{"_km", "kilometres", 1000, 1},
    Unit{"_in", "inches", 254, 10000},
    Unit{"_ft", "feet", 3048, 10000},
    Unit{"_hz", "hertz", 1, 1},
    Unit{"_ms", "milliseconds", 1, 1000},
    Unit{"_us", "microseconds", 1, 1000000},
    Unit{"_s", "seconds", 1, 1},
    Unit{"_percent", "percent", 1, 100},
};

template <class Number>
std::optional<Number> number_from_text(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool is_plain(const std::optional<Unit>& unit) { return !unit || unit->numerator == unit->denominator; }

}  // namespace

std::optional<Unit> unit_of(std::string_view key) {
  for (const Unit& unit : kUnits) {
    if (key.size() > unit.suffix.size() && key.ends_with(unit.suffix)) return unit;
  }
  return std::nullopt;
}

std::string_view without_unit(std::string_view key) {
  const auto unit = unit_of(key);
  return unit ? key.substr(0, key.size() - unit->suffix.size()) : key;
}

std::optional<double> si_from_text(std::string_view text, const std::optional<Unit>& unit) {
  if (is_plain(unit)) return number_from_text<double>(text);
  // The 11 bits more of long double keep the product's last bit right, and let every double be reached from a text.
  const auto number = number_from_text<long double>(text);
  if (!number) return std::nullopt;
  const auto value = static_cast<double>(*number * unit->numerator / unit->denominator);
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string text_from_si(double value, const std::optional<Unit>& unit) {
  std::array<char, 64> text{};
  const auto written = [&](std::to_chars_result result) { return std::string(text.data(), result.ptr); };
  if (is_plain(unit)) {
    const bool handy = value == 0 || (std::fabs(value) >= 1e-4 && std::fabs(value) < 1e15);
    const auto format = handy ? std::chars_format::fixed : std::chars_format::general;
    return written(std::to_chars(text.begin(), text.end(), value, format));
  }
  const long double number = static_cast<long double>(value) * unit->denominator / unit->numerator;
  constexpr int kEnough = 21;  // decimal digits that tell any two long doubles apart
  for (int digits = 1; digits < kEnough; ++digits) {
    const auto shorter = written(std::to_chars(text.begin(), text.end(), number, std::chars_format::general, digits));
    const bool readable = shorter.find("e+") == shorter.npos;
    if (readable && si_from_text(shorter, unit) == value) return shorter;
  }
  return written(std::to_chars(text.begin(), text.end(), number, std::chars_format::general, kEnough));
}

}  // namespace scanway
