#pragma once

#include <cstdint>

#include "common/geometry/pose.h"
#include "modules/simulator/device/base/base_emulator.h"

namespace scanway::simulator {

/// Wheels on slippery ground: of their way a share gets lost, between half and one and a half times of what is set,
/// another one on each stretch of the way. It depends on the seed and the way alone.
class WheelSlip {
 public:
  explicit WheelSlip(std::uint64_t seed) : seed_(seed) {}

  void set_share(double share) { share_ = share; }
  /// The robot's true motion, in its frame at the first moment, while its wheels turn from one to the other.
  Pose motion_between(const WheelMotion& from, const WheelMotion& to);

 private:
  double grip(std::int64_t stretch, std::uint64_t of) const;

  std::uint64_t seed_;
  double share_ = 0.0;
  double driven_m_ = 0.0, turned_ = 0.0;  // By the wheels, either way.
};

}  // namespace scanway::simulator
