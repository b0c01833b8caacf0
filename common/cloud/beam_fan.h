#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace scanway {

/// Beams of one scan line, one after the other, that gave no return within the laser's range: evenly spaced between two
/// directions of the sweep's frame, which are at most kWidestFan apart. A beam leaves from the mirror, which a sweep's
/// origin is the middle of: it runs parallel to the same direction from the origin, a few centimetres beside it.
struct BeamFan {
  /// A unit vector in counts of 1/32767: 0.002 degrees, 0.3 mm at 10 m. Whole numbers, so that a message changes
  /// nothing.
  using Direction = std::array<std::int16_t, 3>;

  Direction first{}, last{};
  std::int16_t beams = 0;  ///< At least 1; of one beam both directions are the same.

  /// Of beam `i`, from 0; unit length.
  Eigen::Vector3d direction(int i) const;

  bool operator==(const BeamFan&) const = default;
};

constexpr double kWidestFan_rad = 0.2;

BeamFan::Direction to_direction(const Eigen::Vector3d& unit);

/// How many beams `step_rad` apart one fan holds at most.
int most_beams_of_fan(double step_rad);

/// Cuts what of a line gave no return into fans. `no_return(beam)` for each of `beams` beams, `step_rad` apart;
/// `add_fan(first, last)` for the first and the last beam of each fan.
template <class NoReturn, class AddFan>
void find_fans(int beams, double step_rad, const NoReturn& no_return, const AddFan& add_fan) {
  const int most = most_beams_of_fan(step_rad);
  for (int first = 0; first < beams; ++first) {
    if (!no_return(first)) continue;
    int last = first;
    while (last + 1 < beams && last + 1 - first < most && no_return(last + 1)) ++last;
    add_fan(first, last);
    first = last;
  }
}

}  // namespace scanway
