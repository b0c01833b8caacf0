#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "common/time/utime.h"

namespace scanway::simulator {

/// What can go wrong with the robot.
enum class FaultKind : std::uint8_t {
  lms_loss,
  tracker_loss,
  base_loss,
  pan_stuck,
  tilt_stuck,
  dirty_window,
  lms_reboot,
  pan_tilt_reboot,
  tracker_reboot,
  base_reboot,
  heading_bias,
  tilt_bias,
  range_bias,
  slip,
  people,
};

/// How one asks for it.
struct FaultForm {
  FaultKind kind{};
  std::string_view name;  ///< "pan-stuck"
  double value = 0.0;     ///< Where none is given.
  double most = 0.0;      ///< The value's limit, on both sides of 0 if it has a sign.
  std::string_view what;  ///< With the value's unit, for people.
};

/// All of them.
std::span<const FaultForm> fault_forms();
const FaultForm& form_of(FaultKind kind);

/// A fault, from `begin` until `end` on the clock of the robot's devices. Of a reboot only the begin counts: its value
/// says how long the device is dark.
struct Fault {
  static constexpr Utime kNever = std::numeric_limits<Utime>::max();

  FaultKind kind{};
  double value = 0.0;
  Utime begin = 0, end = kNever;
};

/// NAME[=VALUE][@SECONDS[+SECONDS]]: what, how much, how long after `now`, for how long; "NAME=0" ends it. Throws
/// InputError.
Fault parse_fault(std::string_view text, Utime now);

}  // namespace scanway::simulator
