#pragma once

namespace scanway {

/// Degrees as radians, rounded once (the detour by long double keeps the product's last bit right).
constexpr double radians(long double degrees) {
  return static_cast<double>(degrees * (3.14159265358979323846264338327950288L / 180.0L));
}

}  // namespace scanway
