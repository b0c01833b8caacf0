#pragma once

#include <algorithm>
#include <cmath>

namespace scanway::polar {

/// Directions about a sensor are told apart in eighths of a degree.
constexpr int kSectors = 2880;
constexpr double kBin = 0.02;                                             // metres: along a direction
constexpr double kSectorWidth = 2.0 * 3.14159265358979323846 / kSectors;  // radians

/// Sector of the direction (x, y), 0 along x, counter-clockwise. A polynomial of our own: this is called for every
/// return and every cell of the map, and a hundredth of a sector is exact enough.
inline int sector_of(float x, float y) {
  const float ax = std::fabs(x), ay = std::fabs(y);
  const float high = std::max(ax, ay), low = std::min(ax, ay);
  const float t = high > 0.0f ? low / high : 0.0f;
  const float s = t * t;
  // Abramowitz and Stegun, Handbook of Mathematical Functions, 4.4.49: error below 1e-5 rad.
  float angle = t * (0.9998660f + s * (-0.3302995f + s * (0.1801410f + s * (-0.0851330f + s * 0.0208351f))));
  constexpr float kPi = 3.14159265f;
  angle = ay > ax ? 0.5f * kPi - angle : angle;
  angle = x < 0.0f ? kPi - angle : angle;
  angle = y < 0.0f ? 2.0f * kPi - angle : angle;
  const int sector = static_cast<int>(angle * (static_cast<float>(kSectors) / (2.0f * kPi)));
  return sector >= kSectors ? sector - kSectors : sector;
}

/// Where (x, y), relative to the sensor, lies.
struct Place {
  Place(double x, double y)
      : range(std::max(std::sqrt(x * x + y * y), 1e-4)),
        bin(static_cast<int>(range / kBin)),
        sector(sector_of(static_cast<float>(x), static_cast<float>(y))) {}

  double range;
  int bin, sector;
};

}  // namespace scanway::polar
