#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "modules/sick_bridge/core/scan.h"

namespace scanway::sick {

/// Counts below this are no ranges: 0 no echo, 1 dazzled, the rest reserved.
constexpr std::uint16_t kFirstRangeCount = 16;

/// Where the device looks ahead, as it counts angles.
constexpr double kAheadDeg = 90.0;

/// The range of one beam in metres, scale and offset applied; nothing when there was no return.
std::optional<double> range_m(const ScanChannel& channel, std::size_t beam);

/// Remission of one beam in digits, scale and offset applied.
double rssi(const ScanChannel& channel, std::size_t beam);

/// The true step between two beams in degrees. The device rounds it to 1/10000 deg (1/6 deg comes as 0.1667), which
/// would put the last of 1141 beams off by 0.038 deg. Steps of the LMS5xx are 2 deg over a whole number.
double true_step_deg(std::uint16_t step);

/// Angle of one beam in degrees: 0 is right, 90 straight ahead, counter-clockwise seen from above.
double beam_angle_deg(const ScanChannel& channel, std::size_t beam);

/// Time from one beam to the next in microseconds: what the mirror needs to turn by the step. It follows from the
/// telegram itself, so it is right for every pair of frequency and resolution and for interlaced modes.
/// Nothing when the telegram says no frequency.
std::optional<double> beam_period_us(const Scan& scan, const ScanChannel& channel);

/// What a device can be set to.
struct ScanMode {
  std::uint32_t frequency = 2500;   ///< 1/100 Hz.
  std::uint32_t resolution = 1667;  ///< 1/10000 deg.
  bool interlaced = false;          ///< Several revolutions with shifted beams make up one resolution.
};

/// Whether an LMS5xx has the mode (variant table of SICK's listing).
bool is_mode_of_lms5xx(std::uint32_t frequency, std::uint32_t resolution);

/// The mode's entry in the variant table, or nothing.
std::optional<ScanMode> find_mode(std::uint32_t frequency, std::uint32_t resolution);

}  // namespace scanway::sick
